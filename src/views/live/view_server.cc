#include "views/live/view_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "base/text/number_of_text.h"
#include "views/http/address.h"
#include "views/http/event_hub.h"
#include "views/http/http_access.h"
#include "views/http/http_server.h"
#include "views/session/view_json.h"

namespace somato {

using live::EventHub;
using live::EventKind;
using live::HttpRequest;
using live::HttpResponse;

namespace {

constexpr auto kBetweenPings = std::chrono::milliseconds(2000);

// A viewer that acknowledges receives pings more often than once in the second from which a page
// states its delay, and no more events than screens show pictures.
constexpr auto kBetweenAcknowledgedPings = std::chrono::milliseconds(500);
constexpr auto kBetweenPictures = std::chrono::milliseconds(16);

std::string_view name_of(EventKind kind) {
  switch (kind) {
    case EventKind::kState:
      return "state";
    case EventKind::kScene:
      return "scene";
    case EventKind::kTraining:
      return "training";
    case EventKind::kFrame:
      break;
  }
  return "frame";
}

std::string event_text(std::string_view name, std::string_view data) {
  return fmt::format("event: {}\ndata: {}\n\n", name, data);
}

// The end of what is to be acknowledged; repeated until it is.
std::string ping_text(const EventHub::Handed& handed) {
  const std::chrono::duration<double> waited = handed.waited;
  return event_text("ping", fmt::format(R"({{"viewer":{},"number":{},"waited":{:.4f}}})",
                                        handed.viewer, handed.number, waited.count()));
}

HttpResponse json_response(std::string body, int status = 200) {
  HttpResponse response;
  response.status = status;
  response.type = "application/json";
  response.body = std::move(body);
  return response;
}

HttpResponse refused(int status, std::string sentence) {
  return live::response_of({status, std::move(sentence)});
}

// In JSON, as the page expects it.
HttpResponse error_response(const Error& error) {
  return json_response(live::json_text({{"error", to_string(error)}}), 400);
}

// A change that is made, but not saved, is not refused.
HttpResponse answer_of_command(const Result<void>& done) {
  if (done) return json_response(R"({"ok":true})");
  live::Json answer{{"error", to_string(done.error())}};
  if (done.error().kind == ErrorKind::kSystem) answer["unsaved"] = true;
  return json_response(live::json_text(answer), 400);
}

HttpResponse answer_of(Result<std::string> answer) {
  return answer ? json_response(std::move(*answer)) : error_response(answer.error());
}

// A file for the viewer, who chooses where it is saved.
HttpResponse file_response(Result<std::string> bytes, std::string_view name) {
  if (!bytes) return error_response(bytes.error());
  HttpResponse response;
  response.type = "application/octet-stream";
  response.body = std::move(*bytes);
  response.headers.emplace_back("Content-Disposition",
                                fmt::format("attachment; filename=\"{}\"", name));
  return response;
}

std::optional<std::size_t> number_in(const HttpRequest& request, std::string_view name) {
  const auto text = request.parameter(name);
  return text ? number_of_text<std::size_t>(*text) : std::nullopt;
}

}  // namespace

class ViewServer::Impl {
 public:
  Impl(ViewSession& session, std::vector<ViewPage> pages, ViewServerSettings settings)
      : session_(session), pages_(std::move(pages)), settings_(std::move(settings)) {}

  Result<void> start() {
    SOMATO_TRY(const auto address, parse_address(settings_.address));
    auto token = live::new_token();
    if (!token) {
      return fail(ErrorKind::kSystem, "the operating system provided no random numbers",
                  "getrandom");
    }
    token_ = std::move(*token);
    auto bound = http_.bind({address.text, settings_.port, settings_.connections,
                             std::chrono::milliseconds(settings_.patience)});
    if (!bound) return bound;
    hosts_ = live::hosts_at(address.text, http_.port());
    access_.emplace(hosts_, token_);
    http_.start([this](const HttpRequest& request) { return answer(request); });
    return {};
  }

  void stop() {
    session_.hub().close();
    http_.stop();
  }

  std::string start_address() const {
    return fmt::format("http://{}/?token={}", hosts_.front(), token_);
  }
  std::uint16_t port() const { return http_.port(); }
  const std::string& token() const { return token_; }

 private:
  // The page's own files contain no secrets: they do not require a token.
  HttpResponse answer(const HttpRequest& request) {
    auto allowed = access_->check_host(request);
    if (!allowed) return response_of(allowed.error());
    if (request.method == "POST") return answer_post(request);
    for (const ViewPage& page : pages_) {
      if (page.path == request.path) return {200, page.type, page.text};
    }
    allowed = access_->check_token(request);
    if (!allowed) return response_of(allowed.error());
    return answer_get(request);
  }

  HttpResponse answer_post(const HttpRequest& request) {
    const auto allowed =
        access_->check_origin(request).and_then([&] { return access_->check_token(request); });
    if (!allowed) return response_of(allowed.error());
    if (request.path == "/api/seen") return seen(request);
    if (request.path != "/api/command") return refused(404, "Unknown path for POST.");
    if (request.header("content-type") != "application/json") {
      return refused(415, "Commands must have the content type application/json.");
    }
    return answer_of_command(session_.command(request.body));
  }

  HttpResponse answer_get(const HttpRequest& request) {
    // Its subscription would never be read.
    if (request.method == "HEAD" && request.path == "/api/events") {
      return refused(405, "Events require GET.");
    }
    if (request.path == "/api/state") return answer_of(session_.state());
    if (request.path == "/api/scene") return latest(EventKind::kScene);
    if (request.path == "/api/neuron") return neuron(request);
    if (request.path == "/api/taxel") return taxel(request);
    if (request.path == "/api/strips") return answer_of(session_.strips());
    if (request.path == "/api/recording") {
      return file_response(session_.recording_file(), "session.mcap");
    }
    if (request.path == "/api/system") {
      return file_response(session_.system_file(), "system.somato");
    }
    if (request.path == "/api/events") return events(request);
    if (request.path == "/api/command") return refused(405, "Commands require POST.");
    if (request.path == "/api/seen") return refused(405, "Acknowledgements require POST.");
    return refused(404, "Not found.");
  }

  HttpResponse latest(EventKind kind) {
    const EventHub::Text text = session_.hub().latest(kind);
    return json_response(text ? *text : "null");
  }

  HttpResponse neuron(const HttpRequest& request) {
    const auto map = request.parameter("map");
    const auto number = number_in(request, "neuron");
    if (!map || !number)
      return refused(400, "The parameters map=NAME and neuron=NUMBER are required.");
    return answer_of(session_.neuron(*map, *number));
  }

  HttpResponse taxel(const HttpRequest& request) {
    const auto number = number_in(request, "element");
    if (!number) return refused(400, "The parameter element=NUMBER is required.");
    return answer_of(session_.taxel(*number));
  }

  // The subscription ends with the stream, also with one that never began.
  HttpResponse events(const HttpRequest& request) {
    const bool acknowledges = request.parameter("acknowledge").has_value();
    const std::shared_ptr<EventHub::Subscription> subscription = session_.hub().subscribe(
        settings_.viewers, acknowledges ? EventHub::Flow::kAcknowledged : EventHub::Flow::kFree);
    if (!subscription) return refused(503, "Too many viewers are connected; try again later.");
    HttpResponse response;
    response.type = "text/event-stream";
    response.stream = [subscription](const HttpResponse::Write& write) {
      send(*subscription, write);
    };
    return response;
  }

  HttpResponse seen(const HttpRequest& request) {
    const auto viewer = number_in(request, "viewer");
    const auto number = number_in(request, "number");
    if (!viewer || !number) {
      return refused(400, "The parameters viewer=NUMBER and number=NUMBER are required.");
    }
    if (session_.hub().acknowledge(*viewer, *number)) return json_response(R"({"ok":true})");
    return refused(400, "No viewer with this number receives events.");
  }

  static void send(EventHub::Subscription& subscription, const HttpResponse::Write& write) {
    const bool acknowledges = subscription.flow() == EventHub::Flow::kAcknowledged;
    while (const auto events =
               subscription.next(acknowledges ? kBetweenAcknowledgedPings : kBetweenPings)) {
      std::string part;
      for (const auto& [kind, text] : *events) part += event_text(name_of(kind), *text);
      if (acknowledges) part += ping_text(subscription.handed());
      if (part.empty()) part = event_text("ping", "{}");
      if (!write(part)) return;
      if (acknowledges) subscription.rest(kBetweenPictures);
    }
  }

  ViewSession& session_;
  std::vector<ViewPage> pages_;
  ViewServerSettings settings_;
  std::string token_;
  std::vector<std::string> hosts_;
  std::optional<live::HttpAccess> access_;
  live::HttpServer http_;
};

Result<std::unique_ptr<ViewServer>> ViewServer::start(ViewSession& session,
                                                      std::vector<ViewPage> pages,
                                                      const ViewServerSettings& settings) {
  auto impl = std::make_unique<Impl>(session, std::move(pages), settings);
  SOMATO_TRY_VOID(impl->start());
  return std::unique_ptr<ViewServer>(new ViewServer(std::move(impl)));
}

ViewServer::ViewServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

ViewServer::~ViewServer() {
  impl_->stop();
}

std::string ViewServer::start_address() const {
  return impl_->start_address();
}

std::uint16_t ViewServer::port() const {
  return impl_->port();
}

const std::string& ViewServer::token() const {
  return impl_->token();
}

}  // namespace somato
