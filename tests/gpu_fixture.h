// One validated device for all tests of a program; a test fails on any validation message that came while it ran.
#pragma once

#include <gtest/gtest.h>

#include "core/gpu/context.h"

namespace gridscope {

class GpuTest : public testing::Test {
 protected:
  static GpuContext& gpu() {
    static GpuContext context({.device = "", .validation = true});
    return context;
  }
  void SetUp() override { messagesBefore_ = gpu().validationMessages(); }
  void TearDown() override { EXPECT_EQ(gpu().validationMessages(), messagesBefore_) << "validation messages, see above"; }

 private:
  uint32_t messagesBefore_ = 0;
};

}  // namespace gridscope
