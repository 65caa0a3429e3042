// SPDX-License-Identifier: Apache-2.0
#include "simulator/truth_files.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>

#include <zlib.h>

#include "base/files.h"
#include "captures/picture_file.h"
#include "captures/png_image.h"

namespace dorsum {
namespace {

constexpr double kHeightStepMm = 0.002;

// gzip (RFC 1952) without name and time, so that the same table gives the same bytes.
std::string Gzip(const std::string& text) {
  z_stream stream{};
  constexpr int kGzipWindow = 15 + 16;
  if (deflateInit2(&stream, 6, Z_DEFLATED, kGzipWindow, 8, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw std::runtime_error("zlib: no memory");
  }
  std::string out(deflateBound(&stream, text.size()) + 32, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

template <class T>
void AppendBytes(std::string& out, T value) {
  static_assert(std::endian::native == std::endian::little);
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

}  // namespace

Status WriteHeights(const View& view, const std::filesystem::path& path) {
  cv::Mat codes(view.height, view.width, CV_16U);
  auto* code = codes.ptr<std::uint16_t>();
  for (const SurfaceSample& sample : view.centre) {
    const double step = std::round(sample.position.z() / kHeightStepMm) + 1.0;
    *code++ = sample.part < 0 ? std::uint16_t{0} : static_cast<std::uint16_t>(std::clamp(step, 1.0, 65535.0));
  }
  return WriteFile(path, EncodePng(codes));
}

Status WriteMaterials(const View& view, const std::filesystem::path& path) {
  cv::Mat materials(view.height, view.width, CV_8U);
  auto* out = materials.ptr<std::uint8_t>();
  for (const SurfaceSample& sample : view.centre) *out++ = static_cast<std::uint8_t>(sample.material);
  return WriteFile(path, EncodePng(materials));
}

Status WriteStripes(const std::vector<TrueStripePoint>& points, const std::filesystem::path& path) {
  std::string table = "order,v,u,z,material,irradiance\n";
  char line[128];
  for (const TrueStripePoint& p : points) {
    // A zero that rounding made negative reads badly.
    const double z = std::abs(p.z) < 5e-7 ? 0.0 : p.z;
    std::snprintf(line, sizeof(line), "%d,%d,%.6f,%.6f,%d,%.4f\n", p.order, p.row, p.u, z,
                  static_cast<int>(p.material), p.irradiance);
    table += line;
  }
  return WriteFile(path, Gzip(table));
}

Status WriteReferencePly(const TriangleMesh& mesh, const std::filesystem::path& path) {
  std::string faces;
  std::size_t count = 0;
  for (const auto& f : mesh.faces) {
    const auto rises = [&](std::uint32_t i) { return mesh.vertices[i].z() > 1e-6; };
    if (!rises(f[0]) && !rises(f[1]) && !rises(f[2])) continue;
    ++count;
    AppendBytes(faces, std::uint8_t{3});
    for (const std::uint32_t i : f) AppendBytes(faces, static_cast<std::int32_t>(i));
  }
  std::string out = "ply\nformat binary_little_endian 1.0\ncomment mm, world frame\nelement vertex " +
                    std::to_string(mesh.vertices.size()) +
                    "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                    std::to_string(count) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Eigen::Vector3d& v : mesh.vertices) {
    for (int i = 0; i < 3; ++i) AppendBytes(out, static_cast<float>(v[i]));
  }
  return WriteFile(path, out + faces);
}

Status WritePicture(const CameraDesign& camera, const cv::Mat& picture, const std::filesystem::path& stem) {
  DORSUM_ASSIGN_OR_RETURN(const cv::Mat sent, ThroughStream(camera, picture));
  return WritePictureFile(camera, sent, stem);
}

}  // namespace dorsum
