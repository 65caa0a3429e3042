// SPDX-License-Identifier: Apache-2.0
// OpenCV's threads are TBB's, whose synchronisation ThreadSanitizer does not see: it gets one.
#include <opencv2/core/utility.hpp>

namespace {

[[gnu::constructor]] void UseOneThread() { cv::setNumThreads(1); }

}  // namespace
