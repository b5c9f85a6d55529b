#pragma once
/// How checks and a student's program speak with each other: values as bytes, in this machine's own order.
///
/// What is read may come from a program that is broken or means harm: every length is held against what is there.

#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace sightline::labs {

/// Bytes that are not what was to be read.
class WireError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Structures that hold vectors or strings name their members: auto wired(X& x) { return std::tie(x.a, x.b); }
template <class X>
concept Wired = requires(X& x) {
  wired(x);
};

class Writer {
 public:
  const std::string& bytes() const { return bytes_; }

  template <class X>
  void put(const X& x) {
    if constexpr (Wired<X>) {
      std::apply([&](const auto&... members) { (put(members), ...); }, wired(const_cast<X&>(x)));
    } else {
      static_assert(std::is_trivially_copyable_v<X> && !std::is_pointer_v<X>, "name the members in wired()");
      bytes_.append(reinterpret_cast<const char*>(&x), sizeof x);
    }
  }
  void put(const std::string& text) {
    put(std::uint64_t(text.size()));
    bytes_ += text;
  }
  template <class X>
  void put(const std::vector<X>& list) {
    put(std::uint64_t(list.size()));
    for (const X& x : list) put(x);
  }
  template <class X>
  void put(const std::optional<X>& x) {
    put(std::uint8_t(x.has_value()));
    if (x) put(*x);
  }
  template <class... X>
  void put(const std::variant<X...>& x) {
    put(std::uint8_t(x.index()));
    std::visit([&](const auto& held) { put(held); }, x);
  }

 private:
  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  /// \throws WireError where the bytes end too early.
  template <class X>
  X get() {
    X x{};
    read(x);
    return x;
  }
  /// \throws WireError where bytes are left.
  void finish() const {
    if (!rest_.empty()) throw WireError(std::to_string(rest_.size()) + " bytes more than expected");
  }

 private:
  template <class X>
  void read(X& x) {
    if constexpr (Wired<X>) {
      std::apply([&](auto&... members) { (read(members), ...); }, wired(x));
    } else {
      static_assert(std::is_trivially_copyable_v<X> && !std::is_pointer_v<X>, "name the members in wired()");
      std::memcpy(&x, take(sizeof x).data(), sizeof x);
    }
  }
  void read(std::string& text) { text = take(get<std::uint64_t>()); }
  template <class X>
  void read(std::vector<X>& list) {
    const auto size = get<std::uint64_t>();
    if (size > rest_.size()) throw WireError("a list of " + std::to_string(size) + " in " + left());
    list.resize(size);
    for (X& x : list) read(x);
  }
  template <class X>
  void read(std::optional<X>& x) {
    if (get<std::uint8_t>() != 0) read(x.emplace());
  }
  template <class... X>
  void read(std::variant<X...>& x) {
    const auto index = get<std::uint8_t>();
    if (index >= sizeof...(X)) throw WireError("kind " + std::to_string(index) + " of " + std::to_string(sizeof...(X)));
    [&]<std::size_t... I>(std::index_sequence<I...>) { ((I == index ? read(x.template emplace<I>()) : void()), ...); }
    (std::index_sequence_for<X...>());
  }

  std::string left() const { return std::to_string(rest_.size()) + " bytes"; }
  std::string_view take(std::uint64_t size) {
    if (size > rest_.size()) throw WireError(std::to_string(size) + " bytes expected, found " + left());
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }

  std::string_view rest_;
};

/// What the first byte of an answer says of the rest.
enum class Reply : std::uint8_t {
  answer,  ///< The value asked for.
  hole,    ///< A function that is not written yet, and the section of the handout that tells of it.
  refusal  ///< what() of an exception.
};

}  // namespace sightline::labs
