// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/result.h"
#include "geometry/light_sheet.h"

namespace dorsum {

// What people write about a device (DESIGN §4): device.toml. `simulate`, `capture` and `design` read the same
// file. Positions are as designed, in the frame with z up from the backplane and x across the stripes; where
// the parts really sit is for calibration to find. Light is measured in units of what brings a white surface
// in the middle of the picture to the sensor's full scale. Ranges are those that ReadDeviceDescription
// accepts.

struct CameraDesign {
  // Where pictures come from: empty: the first camera; "2" or "/dev/video2": that one; "http://…",
  // "rtsp://…": a network stream; a video file; a folder of images; "virtual[:SEED]". Paths count from the
  // working folder.
  std::string source;
  int width = 1600, height = 1200;                                         // px, 64 to 10000
  double focal_length_px = 2080.0;                                         // 50 to 100000
  std::array<double, 5> distortion = {-0.11, 0.06, 0.0003, -0.0002, 0.0};  // k1 k2 p1 p2 k3, each -2 to 2
  Eigen::Vector3d position_mm{-118.0, 0.0, 386.0};                         // z 100 to 3000
  Eigen::Vector3d look_at_mm{14.0, 0.0, 0.0};
  std::string format = "jpeg";  // jpeg | png
  int jpeg_quality = 94;        // 50 to 100; colour at half resolution (4:2:0), as cameras write it
  int stream_jpeg_quality = 0;  // of the JPEG stream through which a webcam sends its pictures, before they
                                // are written to files: 30 to 100; 0: none
  // What a camera at /dev/video is set to; a stream or a recording has been set up by whoever made it.
  std::string stream_format = "mjpeg";  // mjpeg | raw: what it is asked to send
  double laser_exposure_s = 0.0;        // of pictures of a laser, and of those under the LEDs: 0.0001 to 10;
  double led_exposure_s = 0.0;          // both 0: the camera's exposure is left as it is
  int gain = -1;                        // in the driver's units, 0 to 65535; -1: left as it is
  int focus = -1;                       // the same
  int white_balance_k = 0;              // kelvin, 1000 to 20000; 0: left as it is
};

// From light on the lens to numbers in the file.
struct SensorDesign {
  double full_well_e = 9000.0;  // electrons at full scale, 0 (no shot noise) to 1e6
  double read_noise_e = 9.0;    // electrons, 0 to 1000
  double gamma = 1.0;           // code = light^(1/gamma), 0.3 to 4
  double black_level = 0.0;     // share of full scale, 0 to 0.2
  double psf_sigma_px = 0.8;    // blur of lens and pixel, 0 to 5
  double filter_falloff =
      0.25;  // share of light lost in the picture's corner by the narrow-band filter, 0 to 0.95
  double leak_red = 0.08, leak_blue = 0.11;  // green light seen by the other channels, 0 to 1
  bool bayer = false;  // each pixel sees one colour (RGGB), the others are interpolated bilinearly
};

struct GratingDesign {
  double lines_per_mm = 100.0;   // 1 to 5000
  double wavelength_nm = 532.0;  // 300 to 1100
  double turn_deg =
      45.0;         // of the grating about its normal (§2.5); its cosine scales the order step, 0 to 80
  int orders = 10;  // on each side, 1 to 60
  double first_order_efficiency = 0.5;  // relative to the central order, 0.01 to 1
  double last_order_efficiency = 0.17;  // the same for the outermost order, 0.001 to 1
  double efficiency_spread = 0.03;      // standard deviation between single orders, share, 0 to 0.3

  double Step() const;  // change of direction cosine from order to order: lambda / d * cos(turn)
};

struct LaserDesign {
  Eigen::Vector3d position_mm{0.0, 0.0, 395.0};  // where its middle ray leaves the grating, z 100 to 3000
  double half_angle_deg = 22.0;                  // of the fan, 1 to 60
  double relative_power = 1.0;                   // 0.01 to 10
  double tilt_deg = 0.0;          // of the fan against the grating's normal, towards x, -30 to 30
  double fan_distance_mm = 15.0;  // from the fan's origin to the grating, 0 to 100
  double line_sigma_mrad =
      0.9;  // half width of a stripe (one standard deviation) in direction cosine, 0.05 to 20
  FanForm form = FanForm::kFlat;  // flat | conical
  int channel = -1;               // of the controller, 0 to 63; -1: the laser's number
};

struct LedDesign {
  Eigen::Vector3d position_mm{0.0, 0.0, 900.0};  // centre of a round, evenly bright screen, z 100 to 5000
  double radius_mm = 200.0;                      // 0.5 to 1000
  double irradiance = 0.28;                      // that it gives the middle of the backplane, 0 to 4
  int channel = 8;                               // 0 to 63
};

struct LightDesign {
  double laser_irradiance =
      1.5;  // middle of the central stripe below a laser of relative power 1, 0.01 to 100
  double ambient_laser = 0.012;  // daylight in pictures of a laser, 0 to 1
  double ambient_led = 0.02;     // daylight in pictures under the LEDs (other exposure), 0 to 1
};

struct BoardDesign {
  int columns = 11, rows = 8;  // inner corners, 3 to 60
  double square_mm = 15.0;     // 1 to 200
};

// Standard deviations of what a careful assembler gets wrong.
struct MountingDesign {
  double camera_position_mm = 2.0, camera_angle_deg = 0.5;  // 0 to 50, 0 to 10
  double laser_position_mm = 0.6, laser_angle_deg = 0.5;    // 0 to 20, 0 to 10
  double grating_turn_deg = 0.2;                            // 0 to 5
  double focal_length_share = 0.005;                        // 0 to 0.1
  double principal_point_px = 8.0;                          // 0 to 200
};

struct SpeckleDesign {
  double contrast = 0.15;       // standard deviation over mean of laser light on the sensor, 0 to 1
  double correlation_px = 0.6;  // sigma of the Gaussian that shapes its grain, 0 to 10: neighbours d px
                                // apart correlate by exp(-(d / (2 sigma))^2)
};

// How a stripe widens under skin: part of the light comes out after wandering.
struct SkinDesign {
  double line_blur_mm = 0.1;      // added to the line's own width in quadrature, 0 to 5
  double scatter_share = 0.5;     // of the light, in a wider Gaussian, 0 to 1
  double scatter_sigma_mm = 1.3;  // its width, 0.01 to 20
};

struct DeviceDescription {
  std::string name = "four lasers";
  CameraDesign camera;
  SensorDesign sensor;
  GratingDesign grating;
  std::vector<LaserDesign> lasers;  // 1 to 8; their place is their number
  std::vector<LedDesign> leds;      // 1 to 8
  LightDesign light;
  BoardDesign board;
  double calibration_object_height_mm = 50.0;                           // 5 to 500
  std::vector<double> box_heights_mm = {10.0, 20.0, 30.0, 40.0, 50.0};  // up to 32 of 1 to 500
  std::array<double, 2> working_heights_mm = {0.0, 80.0};               // -50 to 500, ascending
  std::string controller_port;   // of the light controller; empty: the first that answers
  int controller_baud = 115200;  // 300 to 4000000
  MountingDesign mounting;
  SpeckleDesign speckle;
  SkinDesign skin;
};

// Four lasers whose combs of stripes interleave evenly, camera to the left: devices/four-lasers.toml.
DeviceDescription DefaultDevice();

// A key that is absent keeps the value that the structs above give it; [[laser]] and [[led]] must be there.
// Unknown keys, wrong types and values out of range are errors that name file, key, value and what is
// allowed.
Result<DeviceDescription> ReadDeviceDescription(const std::filesystem::path& path);

}  // namespace dorsum
