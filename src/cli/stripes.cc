// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "cli/commands.h"
#include "jobs/find_stripes.h"

namespace dorsum {
namespace {

struct Arguments {
  FindStripesRequest request;
  std::vector<std::string> images;
  std::string out;
  bool single_rows = false;
};

void Run(Arguments* arguments, Session* session) {
  FindStripesRequest& request = arguments->request;
  request.images.assign(arguments->images.begin(), arguments->images.end());
  request.out_csv = arguments->out;
  request.pool = !arguments->single_rows;
  const auto found = FindStripes(request, session->MakeContext());
  if (!found.ok()) return session->Fail(found.error());
  session->Print(FoundStripesToText(*found), FoundStripesToJson(*found));
}

}  // namespace

void AddStripes(CLI::App* app, Session* session) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* c = app->add_subcommand("stripes", "Find the laser stripes of images to a fraction of a pixel");
  c->add_option("image", arguments->images, "8-bit colour images, PNG or JPEG")->required();
  c->add_option("-o,--out", arguments->out,
                "CSV to write: row, column, sd, peak, width, segment; with several images led by the image")
      ->required();
  c->add_flag("--single-rows", arguments->single_rows,
              "measure each row by itself instead of pooling along the stripe");
  c->add_option("--width", arguments->request.ridges.width_px,
                "usual standard deviation of the stripes' profile, px; 0 takes it from each image")
      ->check(NumberFrom(0.0, 8.0))
      ->capture_default_str();
  AddCommonOptions(c, session);
  c->footer("Example: dorsum stripes capture/stripesHand1.jpg -o stripes.csv");
  c->callback([arguments, session] { Run(arguments.get(), session); });
}

}  // namespace dorsum
