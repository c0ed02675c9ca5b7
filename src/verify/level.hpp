#pragma once

namespace washtub {

/// How much of the verification is run: `quick` in minutes, at every change; `full` all of it.
enum class VerifyLevel { quick, full };

}  // namespace washtub
