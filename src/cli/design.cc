// SPDX-License-Identifier: Apache-2.0
#include "jobs/design.h"

#include <memory>

#include "cli/commands.h"

namespace dorsum {
namespace {

struct Arguments {
  DesignRequest request;
  DesignSearch search;
  std::string device, out;
  std::string surface = "skin";
  bool searching = false;
};

void AddChanges(CLI::App* c, DesignChanges* changes) {
  const std::string group = "Other than the description";
  const auto number = [c, &group](const char* name, std::optional<double>* value, double min, double max,
                                  const char* help) {
    c->add_option(name, *value, help)->check(NumberFrom(min, max))->group(group);
  };
  number("--lines-per-mm", &changes->lines_per_mm, 1, 5000, "of the gratings (2.7)");
  number("--wavelength-nm", &changes->wavelength_nm, 300, 1100, "of the lasers");
  number("--turn-deg", &changes->turn_deg, 0, 80, "of the gratings about their normals");
  number("--slit-um", &changes->slit_um, 0.001, 1000,
         "width of the gratings' slits: brightness of orders by (2.2)");
  number("--pitch-mm", &changes->pitch_mm, 0.1, 500, "between neighbouring lasers");
  number("--laser-height-mm", &changes->laser_height_mm, 100, 3000, "of the gratings above the backplane");
  number("--camera-height-mm", &changes->camera_height_mm, 100, 3000, "of the camera above the backplane");
  number("--baseline-mm", &changes->baseline_mm, 1, 3000,
         "camera to the middle of the lasers, across the stripes");
  number("--focal-length-px", &changes->focal_length_px, 50, 100000, "of the camera");
  c->add_option("--orders", changes->orders, "on each side")->check(CLI::Range(1, 60))->group(group);
  c->add_option("--lasers", changes->lasers, "how many, all like the first")
      ->check(CLI::Range(1, 8))
      ->group(group);
  c->add_option("--resolution", changes->resolution_px, "of the camera, px: W,H")
      ->delimiter(',')
      ->expected(2)
      ->check(CLI::Range(64, 10000))
      ->group(group);
  c->add_option("--heights", changes->heights_mm, "working volume, mm: LOW,HIGH")
      ->delimiter(',')
      ->expected(2)
      ->check(NumberFrom(-50, 500))
      ->group(group);
}

void AddSearch(CLI::App* c, DesignSearch* search) {
  const std::string group = "Search (with --search)";
  const auto list = [c, &group](const char* name, std::vector<double>* value, int count, double min,
                                double max, const char* help) {
    auto* option =
        c->add_option(name, *value, help)->delimiter(',')->check(NumberFrom(min, max))->group(group);
    option->capture_default_str();
    if (count > 0) option->expected(count);
  };
  list("--gratings", &search->gratings, 0, 1, 5000, "that can be bought, lines/mm: N,N,...");
  list("--grating-range", &search->grating_range, 2, 1, 5000, "made to order, too, lines/mm: LOW,HIGH");
  list("--baselines", &search->baselines_mm, 2, 10, 1000, "mm: LOW,HIGH");
  list("--camera-heights", &search->camera_heights_mm, 2, 100, 3000, "mm: LOW,HIGH");
  const auto number = [c, &group](const char* name, double* value, double min, double max, const char* help) {
    c->add_option(name, *value, help)->check(NumberFrom(min, max))->capture_default_str()->group(group);
  };
  number("--least-pitch-mm", &search->least_pitch_mm, 1, 200, "between lasers: their housings");
  number("--unambiguous-mm", &search->least_unambiguous_mm, 1, 500, "that each laser alone must keep apart");
  number("--least-coverage", &search->least_coverage, 0, 1,
         "share of the volume that each laser must light, in view");
  number("--least-separation", &search->least_separation, 1, 100,
         "of stripes, in standard deviations of their width");
  c->add_option("--best", search->best, "how many designs to list")
      ->check(CLI::Range(1, 50))
      ->capture_default_str()
      ->group(group);
}

void Run(Arguments* arguments, Session* session) {
  DesignRequest& request = arguments->request;
  request.device_path = arguments->device;
  request.out_dir = arguments->out;
  request.surface.skin = arguments->surface == "skin";
  if (arguments->searching) request.search = arguments->search;
  const Result<DesignSummary> summary = Design(request, session->MakeContext());
  if (!summary.ok()) return session->Fail(summary.error());
  session->Print(SummaryToText(*summary), SummaryToJson(*summary));
}

}  // namespace

void AddDesign(CLI::App* app, Session* session) {
  auto arguments = std::make_shared<Arguments>();
  DesignRequest& request = arguments->request;
  CLI::App* c =
      app->add_subcommand("design", "What a device will measure before it is built, or which is best (§2.5)");
  c->add_option("--device", arguments->device,
                "device description (TOML); the built-in four-laser device without it");
  c->add_option("-o,--out", arguments->out,
                "folder to write: device.toml, design.json, design.png, design.html");
  c->add_option("--hand-mm", request.hand_mm, "hand area, across and along the stripes: X,Y")
      ->delimiter(',')
      ->expected(2)
      ->check(NumberFrom(10, 1000))
      ->capture_default_str();
  c->add_option("--surface", arguments->surface, "skin, under which light wanders, or matt paint")
      ->check(CLI::IsMember({"skin", "matt"}))
      ->capture_default_str();
  c->add_option("--albedo", request.surface.albedo, "share of green light that it sends back")
      ->check(NumberFrom(0.01, 1.0))
      ->capture_default_str();
  c->add_option("--pooled-rows", request.surface.pooled_rows, "image rows that one point is measured from")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  c->add_flag("--search", arguments->searching,
              "find the best grating, orders, baseline, laser places and slit");
  AddChanges(c, &request.changes);
  AddSearch(c, &arguments->search);
  AddCommonOptions(c, session);
  c->footer(
      "Example: dorsum design --lines-per-mm 70 --baseline-mm 120 -o mine\n"
      "         dorsum simulate --device mine/device.toml -o scan --scene hand:man:right:p1\n"
      "         dorsum design --search --lasers 3 --hand-mm 200,120 -o best");
  c->callback([arguments, session] { Run(arguments.get(), session); });
}

}  // namespace dorsum
