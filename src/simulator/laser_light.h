// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "base/context.h"
#include "simulator/scene_tracer.h"
#include "simulator/view.h"
#include "simulator/virtual_device.h"

namespace dorsum {

// Share of the fan's brightness at direction cosine beta: 1 inside, 0 outside, with soft ends; less behind
// dirt.
double FanWindow(const VirtualLaser& laser, const FanCoordinates& at);

// Irradiance that order m brings to a surface at the middle of its stripe, without shadow; 1 brings a white
// surface to the sensor's full scale.
//
// A fan spreads its power evenly over beta from a point s behind the grating, and each order as a Gaussian
// over alpha. With the solid angle d_alpha d_beta / gamma, a surface at distance r under the cosine c gets
//   power * efficiency_m * window(beta) * gamma * c / (r (r + s)).
double PeakIrradiance(const VirtualLaser& laser, int order, const FanCoordinates& at,
                      const Eigen::Vector3d& point, const Eigen::Vector3d& normal);

// Whether the light that would reach the point leaves the grating unhindered.
bool IsLit(const SceneTracer& tracer, const FanCoordinates& at, const Eigen::Vector3d& point,
           const Eigen::Vector3d& face_normal);

// Light of one laser that each pixel sends back (CV_32F), before lens and sensor.
cv::Mat LaserLight(const VirtualLaser& laser, const SkinDesign& skin, const SceneTracer& tracer,
                   const View& view, const Context& context);

}  // namespace dorsum
