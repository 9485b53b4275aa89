#include "view/view_rendering.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "base/files/whole_file.h"
#include "terminal/headless_browser.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"
#include "view/demonstrated_recording.h"
#include "view/film.h"
#include "view/view_serving.h"
#include "views/live/view_server.h"
#include "views/live/view_session.h"
#include "views/replay/timeline.h"

namespace somato::program {
namespace {

constexpr std::size_t kFilmWidth = 1600;
constexpr std::size_t kFilmHeight = 900;
constexpr double kLongestPause = 1.0;  // s, between two moments, as in the view

// The page requests the curves up to a moment that it jumps to.
constexpr const char* kHasCurves = " && document.documentElement.dataset.curves === \"true\"";

bool is_film(const std::string& path) {
  return path.ends_with(".webm");
}

// The recording to be drawn, and the index in it of --exploration, which counts from 1. That of a
// demonstration has the one exploration.
struct Drawn {
  ViewSource source;
  std::size_t exploration = 0;
};

Result<Drawn> read_drawn(const Arguments& arguments, ViewSource source) {
  SOMATO_TRY(const auto number, arguments.number("exploration", 1));
  const std::size_t index = number.value_or(1) - 1;
  if (source.demonstrates) {
    SOMATO_TRY(auto recording, demonstrated_recording(std::move(source), index));
    return Drawn{std::move(recording), 0};
  }
  const std::size_t count = source.recording.explorations.size();
  if (index < count) return Drawn{std::move(source), index};
  return fail(ErrorKind::kUsage, "the recording has " + counted(count, "exploration"),
              "--exploration");
}

// The moment of each picture of a film.
std::vector<std::size_t> film_moments(const Exploration& exploration) {
  const live::Timeline timeline(exploration);
  std::vector<std::size_t> moments;
  double end = 0.0;  // s, of the moment in the film
  for (std::size_t moment = 0; moment < timeline.moments(); ++moment) {
    const bool is_last = moment + 1 == timeline.moments();
    const double next = is_last ? timeline.time(moment) + kLongestPause : timeline.time(moment + 1);
    end += std::clamp(next - timeline.time(moment), 0.0, kLongestPause);
    moments.resize(static_cast<std::size_t>(std::lround(end * kFilmRate)), moment);
  }
  return moments;
}

// The moment of the strongest touch in sum, or the last one.
std::size_t picture_moment(const Exploration& exploration) {
  const live::Timeline timeline(exploration);
  std::size_t best = timeline.moments() - 1;
  double most = 0.0;
  for (std::size_t i = 0; i < exploration.channels.size(); ++i) {
    const Channel& channel = exploration.channels[i];
    if (channel.name != "touch") continue;
    for (std::size_t moment = 0; moment < timeline.moments(); ++moment) {
      const std::size_t frames = timeline.frames(i, moment);
      if (frames == 0) continue;
      const auto touch = channel.frames.row(frames - 1);
      const double sum = std::accumulate(touch.begin(), touch.end(), 0.0);
      if (sum > most) best = moment;
      most = std::max(most, sum);
    }
  }
  return best;
}

// An exploration in the view, moment by moment.
class PicturedView {
 public:
  PicturedView(ViewSession& session, HeadlessBrowser browser, std::size_t exploration)
      : session_(session), browser_(std::move(browser)), exploration_(exploration) {}

  Result<std::string> picture(std::size_t moment) {
    return show(moment, "").and_then([&] { return browser_.picture(); });
  }

  // After a jump to this moment, with the curves before it.
  Result<std::string> first_picture(std::size_t moment) {
    return show(moment, moment > 0 ? kHasCurves : "").and_then([&] {
      return browser_.settled_picture();
    });
  }

 private:
  Result<void> show(std::size_t moment, const std::string& condition) {
    SOMATO_TRY_VOID(session_.command(
        fmt::format(R"({{"command":"seek","exploration":{},"frame":{}}})", exploration_, moment)));
    return browser_.wait_until(
        fmt::format("document.documentElement?.dataset.shown === \"{}:{}\"{}", exploration_, moment,
                    condition));
  }

  ViewSession& session_;
  HeadlessBrowser browser_;
  std::size_t exploration_;
};

Result<void> save_film(PicturedView& view, const std::vector<std::size_t>& moments,
                       const std::string& path) {
  SOMATO_TRY(auto film, Film::begin(kFilmWidth, kFilmHeight));
  const Progress progress = terminal_progress("drawing");
  std::string frame;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    if (!progress(i, moments.size()) || stop_requested()) {
      return fail(ErrorKind::kInterrupted, "the film was not completed", path);
    }
    if (i == 0 || moments[i] != moments[i - 1]) {
      SOMATO_TRY(const auto bytes, i == 0 ? view.first_picture(0) : view.picture(moments[i]));
      SOMATO_TRY(const auto picture, detail::read_png(bytes));
      frame = y4m_frame(picture);
    }
    SOMATO_TRY_VOID(film.add(frame));
  }
  SOMATO_TRY_VOID(film.save(path));
  print_summary(
      fmt::format("{}: {} at {} a second\n", path, counted(moments.size(), "picture"), kFilmRate));
  return {};
}

Result<void> save_picture(PicturedView& view, std::size_t moment, const std::string& path) {
  SOMATO_TRY(const auto bytes, view.first_picture(moment));
  SOMATO_TRY_VOID(save_whole(path, bytes));
  print_summary(fmt::format("{}: frame {}\n", path, moment + 1));
  return {};
}

}  // namespace

std::vector<Flag> rendering_flags() {
  return {
      output_flag(
          "--render",
          "Save an exploration of the recording or of --demo as it stands in the view, "
          "without a window: a film (.webm), or a picture of its strongest touch (.png); requires "
          "the programs chromium and, for films, vpxenc"),
      {"--exploration", "With --render: number of the exploration, from 1. Default: 1"}};
}

Result<void> check_rendering(const Arguments& arguments) {
  if (!arguments.has("render")) {
    if (!arguments.has("exploration")) return {};
    return fail(ErrorKind::kUsage, "has no effect without --render", "--exploration", "omit it");
  }
  for (const std::string flag : {"body", "device", "topics", "output", "open", "port", "address"}) {
    if (!arguments.has(flag) || (flag == "body" && arguments.has("demo"))) continue;
    return fail(ErrorKind::kUsage, "has no effect with --render", "--" + flag,
                "record the explorations first, with somato explore");
  }
  const std::string path = arguments.text("render");
  if (is_film(path) || path.ends_with(".png")) return {};
  return fail(ErrorKind::kUsage, "a film ends in .webm, a picture in .png", path);
}

Result<void> render_view(const Arguments& arguments, ViewSource source) {
  const std::string path = arguments.text("render");
  SOMATO_TRY(auto pages, view_pages());
  catch_stop_requests();
  SOMATO_TRY(auto drawn, read_drawn(arguments, std::move(source)));
  const Exploration& exploration = drawn.source.recording.explorations[drawn.exploration];
  const auto moments = film_moments(exploration);
  const std::size_t moment = picture_moment(exploration);
  ViewSession session(std::move(drawn.source), {false, 1.0});
  session.start();
  SOMATO_TRY_VOID(session.command(R"({"command":"pause"})"));
  SOMATO_TRY(const auto server, ViewServer::start(session, std::move(pages)));
  SOMATO_TRY(auto browser,
             HeadlessBrowser::open(server->start_address() + "&picture", kFilmWidth, kFilmHeight));
  PicturedView view(session, std::move(browser), drawn.exploration);
  return is_film(path) ? save_film(view, moments, path) : save_picture(view, moment, path);
}

}  // namespace somato::program
