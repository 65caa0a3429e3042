// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <opencv2/core.hpp>

namespace dorsum {

// Heights over a square lattice of the image: node (column c, row r) lies at pixel (u0 + step c, v0 + step
// r). Only active nodes carry a height; those form the support of the surface.
struct PlateLattice {
  double u0 = 0.0, v0 = 0.0;  // px
  double step_px = 2.5;
  cv::Mat1b active;     // 0 or 255
  cv::Mat1f z;          // mm
  cv::Mat3f stiffness;  // weights of z_xx^2, z_xy^2 and z_yy^2, one triple per node, above 0

  double U(int c) const { return u0 + step_px * c; }
  double V(int r) const { return v0 + step_px * r; }
};

// A height seen at an image point. Weight: 1 / variance, mm^-2; 0 leaves the sample out.
struct PlateSample {
  float u = 0.0F, v = 0.0F;  // px
  float z = 0.0F;            // mm
  float weight = 0.0F;
};

// Where a pixel lies between the nodes of a lattice; not known unless all four corners are active.
struct LatticePlace {
  int c = -1, r = -1;
  float fc = 0.0F, fr = 0.0F;  // from that node to the next, 0 to 1

  bool known() const { return c >= 0; }
};

LatticePlace FindPlace(const PlateLattice& lattice, double u, double v);
std::vector<LatticePlace> FindPlaces(const PlateLattice& lattice, const std::vector<PlateSample>& samples);

struct PlateOptions {
  double mm_per_px = 0.2;    // of the object, above 0
  double tension = 1e-4;     // weight of the squared slope, keeps what no sample holds from swinging, >= 0
  int max_iterations = 100;  // of conjugate gradients over several grids (plate_solver.h), 1 to 100000
  double tolerance = 1e-4;   // of the residual against its start, 0 to 1
};

// The thin plate that minimises
//   sum w_i (z(u_i, v_i) - z_i)^2 + integral (s_xx z_xx^2 + 2 s_xy z_xy^2 + s_yy z_yy^2) dx dy
// over the active nodes, bilinear between nodes, free at its borders (Wahba 1990, Terzopoulos 1986). It
// starts from lattice->z. Samples without four active corners are left out. Returns the iterations made.
int SolvePlate(const std::vector<PlateSample>& samples, const PlateOptions& options, PlateLattice* lattice);

// The lattice with every second node; active where an active node needs it for interpolation.
PlateLattice Coarsen(const PlateLattice& fine);

// Fills fine->z by bilinear interpolation of the next coarser lattice.
void Prolong(const PlateLattice& coarse, PlateLattice* fine);

// Height at a place; NaN where that is not known, which is unless all four corners are active.
float HeightAt(const PlateLattice& lattice, const LatticePlace& place);
float HeightAt(const PlateLattice& lattice, double u, double v);

}  // namespace dorsum
