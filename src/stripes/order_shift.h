// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>

#include "base/context.h"
#include "geometry/calibration.h"
#include "stripes/stripes.h"

namespace dorsum {

struct OrderShiftOptions {
  int min_rows = 40;   // of an order that counts, above 0
  int min_orders = 5;  // of a laser that counts, 4 to 100
  int max_shift = 2;   // orders, 1 to 5
  double better =
      0.6;  // another numbering is believed when it leaves at most this share of the deviations, 0 to 1
};

// How the orders' brightness on the object fits that on the empty backplane.
struct OrderShift {
  int lasers = 0;             // that could be compared; 0: nothing is known
  int shift = 0;              // orders to add to all of them so that it fits; 0: it fits as it is
  double left = 0.0;          // mean deviation of the peaks' natural logarithms with the given orders
  double left_shifted = 0.0;  // and with `shift`
};

// Efficiencies of a grating differ from order to order, the central one's most (§2.5), so brightness tells a
// numbering that is wrong as a whole, as when an object reaches so high that another order's heights fall
// into the working volume. Peaks are taken relative to the picture under the LEDs (`green`, CV_8UC1), and a
// linear change over the orders is allowed for the lights' directions. Orders without a reference stripe do
// not count.
OrderShift FindOrderShift(const IndexedStripes& stripes, const cv::Mat& green, const DeviceGeometry& device,
                          const OrderShiftOptions& options, const Context& context = {});

}  // namespace dorsum
