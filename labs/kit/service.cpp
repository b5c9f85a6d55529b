#include "labs/kit/service.h"

#include <unistd.h>

#include <cerrno>
#include <exception>

#include "labs/kit/frame.h"

namespace sightline::labs {
namespace {

bool read_all(int from, char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t count = ::read(from, bytes, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

bool write_all(int to, const char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t count = ::write(to, bytes, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

}  // namespace

int Service::serve(int in, int out) {
  std::uint64_t size = 0;
  std::string message;
  while (read_all(in, reinterpret_cast<char*>(&size), sizeof size)) {
    message.resize(size);
    if (!read_all(in, message.data(), size)) return 1;
    Writer reply;
    try {
      Reader question(message);
      const auto name = question.get<std::string>();
      const auto found = answers_.find(name);
      if (found == answers_.end()) throw WireError("no question '" + name + "'");
      Writer answer;
      answer.put(Reply::answer);
      found->second(question, answer);
      reply = std::move(answer);
    } catch (const NotYet& hole) {
      reply.put(Reply::hole);
      reply.put(hole.function());
      reply.put(hole.section());
    } catch (const std::exception& error) {
      reply.put(Reply::refusal);
      reply.put(std::string(error.what()));
    }
    size = reply.bytes().size();
    if (!write_all(out, reinterpret_cast<const char*>(&size), sizeof size) ||
        !write_all(out, reply.bytes().data(), size)) {
      return 1;
    }
  }
  return 0;
}

}  // namespace sightline::labs

int main() {
  sightline::labs::Service service;
  sightline::labs::offer(service);
  return service.serve(sightline::labs::questions_descriptor, sightline::labs::answers_descriptor);
}
