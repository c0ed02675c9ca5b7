#pragma once

namespace washtub {

/// From now on SIGINT, SIGTERM and SIGUSR1 (which mpirun passes on) ask the run to stop.
void install_stop_handlers();

/// Whether this process was asked to stop; ranks must agree before acting on it.
bool stop_requested();

}  // namespace washtub
