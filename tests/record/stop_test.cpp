#include "record/stop.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

namespace washtub {
namespace {

TEST(SignalCounter, OnlyALaterOneEndsAtOnce) {
  SignalCounter counter;
  EXPECT_FALSE(counter.is_second(SIGHUP));
  EXPECT_FALSE(counter.is_second(SIGTERM)) << "a scheduler tells everybody at the same time";
  usleep(1'100'000);
  EXPECT_FALSE(counter.is_second(SIGHUP))
      << "the shell and the system both tell of a closed terminal";
  EXPECT_FALSE(counter.is_second(SIGUSR1));
  EXPECT_TRUE(counter.is_second(SIGINT));
  EXPECT_TRUE(counter.is_second(SIGTERM));
}

}  // namespace
}  // namespace washtub
