// SPDX-License-Identifier: Apache-2.0
#include "jobs/design_changes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "captures/device_description_toml.h"
#include "captures/names.h"
#include "jobs/design_device.h"

namespace dorsum {
namespace {

template <class T, class U>
void Set(const std::optional<U>& wanted, T* value) {
  if (wanted) *value = *wanted;
}

std::string Short(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

Status ChangeGrating(const DesignChanges& changes, GratingDesign* grating) {
  Set(changes.lines_per_mm, &grating->lines_per_mm);
  Set(changes.wavelength_nm, &grating->wavelength_nm);
  Set(changes.turn_deg, &grating->turn_deg);
  Set(changes.orders, &grating->orders);
  const double step = grating->Step();
  if (!(step > 0.0 && step <= 0.95)) {
    return BadInput("a grating of " + Short(grating->lines_per_mm) +
                    " lines/mm sends no order but the central one "
                    "into view: sin(phi) of the first would be " +
                    Short(step) + "; with 532 nm and stripes 15 mm apart, 100 lines/mm are usual");
  }
  if (!changes.orders) grating->orders = std::min(grating->orders, MostOrders(*grating));
  if (!changes.slit_um) return {};
  const double period = GratingOf(*grating).PeriodUm();
  if (!(*changes.slit_um > 0.0 && *changes.slit_um < period)) {
    return BadInput("a slit of " + Short(*changes.slit_um) + " um does not fit a grating whose period is " +
                    Short(period) + " um; it must be narrower than that");
  }
  SetSlit(*changes.slit_um, grating);
  return {};
}

void ChangeLasers(const DesignChanges& changes, DeviceDescription* d) {
  if (changes.lasers || changes.pitch_mm) {
    const int count = changes.lasers.value_or(static_cast<int>(d->lasers.size()));
    // Neighbours three quarters of a spacing apart interleave evenly where there are four.
    double pitch = 0.75 * d->grating.Step() * d->lasers.front().position_mm.z();
    if (d->lasers.size() > 1) pitch = std::abs(d->lasers[1].position_mm.x() - d->lasers[0].position_mm.x());
    PlaceLasers(count, changes.pitch_mm.value_or(pitch), MiddleOfLasers(*d), &d->lasers);
  }
  if (changes.laser_height_mm) {
    for (LaserDesign& laser : d->lasers) laser.position_mm.z() = *changes.laser_height_mm;
  }
}

void ChangeCamera(const DesignChanges& changes, DeviceDescription* d) {
  CameraDesign& camera = d->camera;
  Set(changes.camera_height_mm, &camera.position_mm.z());
  Set(changes.focal_length_px, &camera.focal_length_px);
  if (changes.resolution_px.size() == 2) {
    camera.width = changes.resolution_px[0];
    camera.height = changes.resolution_px[1];
  }
  if (changes.heights_mm.size() == 2) d->working_heights_mm = {changes.heights_mm[0], changes.heights_mm[1]};
  if (!changes.baseline_mm) return;
  const double middle = MiddleOfLasers(*d);
  const double side = camera.position_mm.x() > middle ? 1.0 : -1.0;
  camera.position_mm.x() = middle + side * *changes.baseline_mm;
}

}  // namespace

void SetSlit(double slit_um, GratingDesign* grating) {
  const SlitGrating slits = GratingOf(*grating);
  grating->first_order_efficiency = std::clamp(RelativeOrderIntensity(slits, slit_um, 1), 0.01, 1.0);
  grating->last_order_efficiency =
      std::clamp(RelativeOrderIntensity(slits, slit_um, grating->orders), 0.001, 1.0);
}

void PlaceLasers(int count, double pitch_mm, double middle_mm, std::vector<LaserDesign>* lasers) {
  const LaserDesign first = lasers->front();
  lasers->clear();
  for (int k = 0; k < std::clamp(count, 1, kMaxLasers); ++k) {
    LaserDesign laser = first;
    laser.position_mm.x() = middle_mm + pitch_mm * (k - 0.5 * (count - 1));
    laser.channel = k;
    lasers->push_back(laser);
  }
}

double MiddleOfLasers(const DeviceDescription& description) {
  double sum = 0.0;
  for (const LaserDesign& laser : description.lasers) sum += laser.position_mm.x();
  return sum / static_cast<double>(description.lasers.size());
}

int MostOrders(const GratingDesign& grating) {
  return static_cast<int>(std::clamp(std::floor(0.95 / grating.Step() + 1e-9), 0.0, 60.0));
}

Result<DeviceDescription> ApplyChanges(DeviceDescription description, const DesignChanges& changes) {
  if (description.lasers.empty()) return BadInput("the device has no laser; describe at least one");
  if (changes.lasers && (*changes.lasers < 1 || *changes.lasers > kMaxLasers))
    return BadInput("a device has 1 to " + std::to_string(kMaxLasers) + " lasers");
  DORSUM_RETURN_IF_ERROR(ChangeGrating(changes, &description.grating));
  ChangeLasers(changes, &description);
  ChangeCamera(changes, &description);
  // The reader of descriptions knows what is allowed.
  return ParseDeviceDescription(DeviceDescriptionToToml(description), "the device as asked for");
}

}  // namespace dorsum
