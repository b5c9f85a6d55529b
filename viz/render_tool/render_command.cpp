#include "viz/render_tool/render_command.h"

#include <chrono>
#include <cstdio>
#include <iostream>
#include <optional>

#include "sightline/io/interruption.h"
#include "sightline/io/output_file.h"
#include "sightline/render/checkpoint.h"
#include "sightline/render/exposure.h"
#include "sightline/render/ray_count.h"
#include "sightline/scene/scenes.h"
#include "viz/render_tool/monitor.h"
#include "viz/render_tool/picture_files.h"
#include "viz/render_tool/source.h"
#include "viz/run_tool.h"

namespace sightline::render_tool {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::filesystem::path beside(const std::filesystem::path& picture, const char* ending) {
  return picture.string() + ending;
}

void say(const std::string& text) { std::cerr << "sightline-render: " << text << '\n'; }

class Job {
 public:
  Job(const Request& request, const PictureSource& source)
      : request_(request),
        source_(source),
        checkpoint_(beside(request.out, ".checkpoint")),
        film_(initial()),
        first_rays_(rays_of(film_.progress().counters)) {}

  /// The exit status.
  int run(const Exposer& exposer, Progress* progress) {
    bool is_done = false;
    {
      const Interruption interruption;
      std::optional<Preview> preview;
      if (request_.previews) preview.emplace(film_.state(), request_.exposure);
      try {
        const Monitor monitor(film_,
                              {progress, preview ? &*preview : nullptr, checkpoint_,
                               std::chrono::duration<double>(request_.checkpoint_interval), source_.fingerprint()});
        is_done = exposer(film_, source_, {.threads = request_.settings.threads}, Interruption::is_wished());
      } catch (...) {
        keep();
        throw;
      }
    }
    if (progress) progress->clear();
    try {
      write();
    } catch (...) {
      keep();  // what took its time is not lost with a picture that cannot be written
      throw;
    }
    return is_done ? finish() : stop();
  }

 private:
  FilmState initial() const {
    const FilmState blank = blank_film(source_.width(), source_.height(), source_.samples(),
                                       request_.settings.error_bound, facts_for(request_.aovs));
    const bool is_there = std::filesystem::exists(checkpoint_);
    if (request_.resumes && is_there) return read_checkpoint(checkpoint_, blank, source_.fingerprint());
    if (request_.resumes) say(checkpoint_.string() + " is not there: rendering from the beginning");
    if (!request_.resumes && is_there) say(checkpoint_.string() + " is left aside: --resume would go on with it");
    return blank;
  }

  void keep() const { write_checkpoint(checkpoint_, film_.state(), source_.fingerprint()); }

  double share() const {
    const FilmProgress progress = film_.progress();
    return static_cast<double>(progress.done) / static_cast<double>(progress.expected);
  }

  void write() const {
    write_pictures(request_, film_.state(), {source_.samples(), share(), seconds_since(start_)});
    if (request_.explains) {
      write_text(beside(request_.out, ".bill.txt"), bill_of(source_, film_.state().counters, seconds_since(start_)));
    }
  }

  int finish() const {
    std::error_code ignored;
    std::filesystem::remove(checkpoint_, ignored);
    if (request_.is_quiet) return success;
    const FilmProgress progress = film_.progress();
    const double seconds = seconds_since(start_);
    const double pixels = static_cast<double>(source_.width()) * source_.height();
    char text[160];
    std::snprintf(text, sizeof text, ": %d x %d, %.4g samples a pixel, %.1f s, %.2f million rays/s", source_.width(),
                  source_.height(), static_cast<double>(progress.done) / pixels, seconds,
                  static_cast<double>(rays_of(progress.counters) - first_rays_) / seconds / 1e6);
    say(request_.out + text);
    return success;
  }

  int stop() const {
    keep();
    say(request_.out + " has " + std::to_string(static_cast<int>(100 * share())) +
        "% of its samples; the same command with --resume goes on");
    return 128 + Interruption::signal();
  }

  const Request& request_;
  const PictureSource& source_;
  std::filesystem::path checkpoint_;
  Film film_;
  std::uint64_t first_rays_;
  Clock::time_point start_ = Clock::now();
};

/// Whatever cannot be written is told before anything is rendered.
void check_files(const Request& request) {
  for (const auto& file : picture_files(request)) const OutputFile probe(file);
  const OutputFile probe(beside(request.out, ".checkpoint"));
}

}  // namespace

int run(int argc, const char* const* argv, const std::filesystem::path& data_dir, const Exposer& exposer) {
  Request request;
  if (const std::optional<int> status = parse_request(argc, argv, request)) return *status;
  if (!request.is_plan) check_files(request);

  std::optional<Progress> shown;
  if (!request.is_quiet) shown.emplace();
  Progress* progress = shown ? &*shown : nullptr;
  if (progress) progress->say("reading " + request.scene);
  const auto scene = std::make_shared<const Scene>(make_scene(request.scene, data_dir));
  if (progress) progress->clear();
  for (const std::string& warning : scene->warnings) say(request.scene + ": " + warning);
  if (progress) progress->say("building what finds surfaces");
  const std::unique_ptr<PictureSource> source = source_of(scene, request.settings);
  if (progress) progress->clear();
  if (request.is_plan) {
    print_plan(*source, std::cout);
    return success;
  }
  return Job(request, *source).run(exposer, progress);
}

std::unique_ptr<PictureSource> source_of_command(int argc, const char* const* argv,
                                                 const std::filesystem::path& data_dir) {
  Request request;
  if (parse_request(argc, argv, request)) throw std::invalid_argument("expected a scene, found a call for help");
  return source_of(std::make_shared<const Scene>(make_scene(request.scene, data_dir)), request.settings);
}

}  // namespace sightline::render_tool
