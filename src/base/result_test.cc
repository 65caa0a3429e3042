// SPDX-License-Identifier: Apache-2.0
#include "base/result.h"

#include <memory>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "base/context.h"

namespace dorsum {
namespace {

Result<int> Half(int x) {
  if (x % 2 != 0) return UsageError("odd");
  return x / 2;
}

Result<int> Quarter(int x) {
  DORSUM_ASSIGN_OR_RETURN(const int half, Half(x));
  DORSUM_ASSIGN_OR_RETURN(const int quarter, Half(half));
  return quarter;
}

Status CheckQuarter(int x) {
  DORSUM_RETURN_IF_ERROR(Quarter(x));
  return {};
}

TEST(Result, TheWrongSideThrows) {
  const Result<int> value(3), error(BadInput("x"));
  EXPECT_TRUE(value.ok());
  EXPECT_FALSE(error.ok());
  EXPECT_EQ(*value, 3);
  EXPECT_EQ(error.error().message, "x");
  EXPECT_THROW(static_cast<void>(value.error()), std::logic_error);
  EXPECT_THROW(static_cast<void>(error.value()), std::logic_error);
  EXPECT_THROW(static_cast<void>(*error), std::logic_error);
}

TEST(Result, StatusTheWrongSideThrows) {
  EXPECT_TRUE(Status().ok());
  EXPECT_THROW(static_cast<void>(Status().error()), std::logic_error);
  EXPECT_EQ(Status(Cancelled()).error().code, ErrorCode::kCancelled);
}

TEST(Result, ErrorsPassThroughTheMacros) {
  EXPECT_EQ(Quarter(8).value(), 2);
  EXPECT_EQ(Quarter(6).error().message, "odd");
  EXPECT_TRUE(CheckQuarter(4).ok());
  EXPECT_EQ(CheckQuarter(3).error().code, ErrorCode::kUsage);
}

TEST(Result, MovesWhatCannotBeCopied) {
  Result<std::unique_ptr<int>> result(std::make_unique<int>(5));
  const std::unique_ptr<int> taken = std::move(result).value();
  EXPECT_EQ(*taken, 5);
}

TEST(Context, CancellingIsSeen) {
  std::atomic<bool> cancel{false};
  Context context;
  EXPECT_TRUE(context.CheckCancelled().ok());
  context.cancel = &cancel;
  EXPECT_TRUE(context.CheckCancelled().ok());
  cancel = true;
  EXPECT_EQ(context.CheckCancelled().error().code, ErrorCode::kCancelled);
}

}  // namespace
}  // namespace dorsum
