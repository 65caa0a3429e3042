// SPDX-License-Identifier: Apache-2.0
#include "surface/ply_reader.h"

#include <gtest/gtest.h>

#include "base/files.h"

namespace dorsum {
namespace {

Result<PlyReader> OpenText(const std::string& name, const std::string& content) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / name;
  EXPECT_TRUE(WriteFile(path, content).ok());
  return PlyReader::Open(path);
}

constexpr const char* kHeader =
    "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uchar uchar vertex_indices\n"
    "property uchar shade\nend_header\n";

TEST(PlyReader, AListBetweenScalarsIsPassedOver) {
  Result<PlyReader> reader = OpenText("reader_list.ply", std::string(kHeader) + "\x03\x01\x02\x03\x09");
  ASSERT_TRUE(reader.ok());
  const PlyElement face = reader->elements().front();
  const auto columns = reader->Columns(face, {"shade"});
  ASSERT_TRUE(columns.ok());
  std::vector<double> scalars, list;
  ASSERT_TRUE(reader->ReadRow(face, &scalars, &list).ok());
  EXPECT_EQ(list, (std::vector<double>{1.0, 2.0, 3.0}));
  EXPECT_EQ(scalars.at(columns->front()), 9.0);
}

TEST(PlyReader, ARowThatIsCutOffIsAnErrorNotARead) {
  Result<PlyReader> reader = OpenText("reader_cut.ply", std::string(kHeader) + "\x03\x01");
  ASSERT_TRUE(reader.ok());
  std::vector<double> scalars, list;
  const Status status = reader->ReadRow(PlyElement(reader->elements().front()), &scalars, &list);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().message.find("cut off"), std::string::npos);
}

TEST(PlyReader, AMissingPropertyIsNamed) {
  const Result<PlyReader> reader = OpenText("reader_missing.ply", kHeader);
  ASSERT_TRUE(reader.ok());
  const auto columns = reader->Columns(reader->elements().front(), {"sigma"});
  ASSERT_FALSE(columns.ok());
  EXPECT_NE(columns.error().message.find("'sigma'"), std::string::npos);
}

}  // namespace
}  // namespace dorsum
