#include "program/progress_bar.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace groundgrid::program {
namespace {

using namespace std::chrono_literals;

constexpr int kBarWidth = 30;
constexpr auto kRedrawInterval = 100ms;
constexpr const char* kClearLine = "\r\x1b[K";

// Takes the bar away before a message, which would else be written into it.
class AboveTheBar final : public spdlog::sinks::sink {
 public:
  explicit AboveTheBar(spdlog::sink_ptr inner) : inner_(std::move(inner)) {}

  void log(const spdlog::details::log_msg& message) override {
    std::fputs(kClearLine, stderr);
    inner_->log(message);
  }
  void flush() override { inner_->flush(); }
  void set_pattern(const std::string& pattern) override { inner_->set_pattern(pattern); }
  void set_formatter(std::unique_ptr<spdlog::formatter> formatter) override {
    inner_->set_formatter(std::move(formatter));
  }

 private:
  spdlog::sink_ptr inner_;
};

std::string clock_time(double seconds) {
  const long whole = std::lround(seconds);
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

std::string progress_line(std::size_t done, std::size_t all, double seconds) {
  const double share =
      static_cast<double>(done) / static_cast<double>(std::max<std::size_t>(all, 1));
  const auto filled = static_cast<std::size_t>(share * kBarWidth);
  std::string bar(filled, '=');
  if (filled < kBarWidth) bar += '>';
  const double rate = seconds > 0.0 ? static_cast<double>(done) / seconds : 0.0;
  const std::string left =
      rate > 0.0 ? clock_time(static_cast<double>(all - done) / rate) + " left" : "";
  return fmt::format("[{:<{}}] {:>{}}/{}  {:.1f} scans/s  {}", bar, kBarWidth, done,
                     fmt::formatted_size("{}", all), all, rate, left);
}

ProgressBar::ProgressBar(std::size_t scans) : shown_(::isatty(STDERR_FILENO) == 1), scans_(scans) {
  if (!shown_) return;
  sinks_before_ = spdlog::default_logger()->sinks();
  for (spdlog::sink_ptr& sink : spdlog::default_logger()->sinks())
    sink = std::make_shared<AboveTheBar>(sink);
}

ProgressBar::~ProgressBar() {
  if (!shown_) return;
  std::fputs(kClearLine, stderr);
  spdlog::default_logger()->sinks() = sinks_before_;
}

void ProgressBar::advance() {
  ++done_;
  if (!shown_ || (Clock::now() - drawn_ < kRedrawInterval && done_ < scans_)) return;
  drawn_ = Clock::now();
  draw();
}

void ProgressBar::draw() const {
  const std::chrono::duration<double> time = Clock::now() - begin_;
  std::fputs((kClearLine + progress_line(done_, scans_, time.count())).c_str(), stderr);
}

}  // namespace groundgrid::program
