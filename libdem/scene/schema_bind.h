// From a member of a scene struct to a schema key: the conversions between members and nodes, and the helpers that fill
// Key.
#pragma once

#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "libdem/scene/schema.h"

namespace dem::bind {

inline Node to_node(bool v) { return Node::of(v); }
inline Node to_node(double v) { return Node::of(v); }
inline Node to_node(const std::string& v) { return Node::of(v); }
inline Node to_node(int v) { return Node::of(static_cast<std::int64_t>(v)); }
inline Node to_node(std::uint32_t v) { return Node::of(static_cast<std::int64_t>(v)); }
inline Node to_node(std::uint64_t v) { return Node::of(static_cast<std::int64_t>(v)); }
inline Node to_node(const Vec3d& v) { return Node::array_of({Node::of(v.x), Node::of(v.y), Node::of(v.z)}); }
inline Node to_node(const Quatd& q) {
  return Node::array_of({Node::of(q.w), Node::of(q.x), Node::of(q.y), Node::of(q.z)});
}
template <class T, std::size_t N>
Node to_node(const std::array<T, N>& v) {
  std::vector<Node> items;
  for (const T& x : v) items.push_back(to_node(x));
  return Node::array_of(std::move(items));
}
template <class T>
Node to_node(const std::vector<T>& v) {
  std::vector<Node> items;
  items.reserve(v.size());
  for (const T& x : v) items.push_back(to_node(x));
  return Node::array_of(std::move(items));
}

// The node has been checked against the key before: no errors here.
inline void from_node(const Node& n, bool& v) { v = n.boolean; }
inline void from_node(const Node& n, double& v) { v = n.as_number(); }
inline void from_node(const Node& n, std::string& v) { v = n.text; }
template <class T>
requires std::is_integral_v<T>
void from_node(const Node& n, T& v) {
  v = n.kind == Node::Kind::integer ? static_cast<T>(n.integer) : static_cast<T>(n.number);
}
inline void from_node(const Node& n, Vec3d& v) {
  for (int i = 0; i < 3; ++i) v[i] = n.items[static_cast<std::size_t>(i)].as_number();
}
inline void from_node(const Node& n, Quatd& q) {
  q = {n.items[0].as_number(), n.items[1].as_number(), n.items[2].as_number(), n.items[3].as_number()};
  const double square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  // A quaternion that is unit to round-off stays as it is: what is written reads back to the same bits.
  if (std::abs(square - 1) > 0x1p-50) q = shapes::normalized(q);
}
template <class T, std::size_t N>
void from_node(const Node& n, std::array<T, N>& v) {
  for (std::size_t i = 0; i < N; ++i) from_node(n.items[i], v[i]);
}
template <class T>
void from_node(const Node& n, std::vector<T>& v) {
  v.resize(n.items.size());
  for (std::size_t i = 0; i < v.size(); ++i) from_node(n.items[i], v[i]);
}

template <class T>
constexpr KeyType type_of() {
  if constexpr (std::is_same_v<T, bool>)
    return KeyType::boolean;
  else if constexpr (std::is_same_v<T, double>)
    return KeyType::number;
  else if constexpr (std::is_integral_v<T>)
    return KeyType::integer;
  else if constexpr (std::is_same_v<T, Vec3d>)
    return KeyType::vector;
  else if constexpr (std::is_same_v<T, Quatd>)
    return KeyType::quaternion;
  else if constexpr (std::is_same_v<T, std::vector<Vec3d>>)
    return KeyType::vectors;
  else if constexpr (std::is_same_v<T, std::vector<std::vector<Vec3d>>>)
    return KeyType::outlines;
  else if constexpr (std::is_same_v<T, std::vector<std::array<double, 4>>>)
    return KeyType::planes;
  else if constexpr (std::is_same_v<T, std::vector<std::array<std::uint32_t, 3>>>)
    return KeyType::triangles;
  else if constexpr (std::is_same_v<T, std::vector<std::array<double, 2>>>)
    return KeyType::pairs;
  else if constexpr (std::is_same_v<T, std::vector<std::string>>)
    return KeyType::texts;
  else
    return KeyType::text;
}

template <class C, class T>
struct Member {
  using Class = C;
  using Type = T;
};
template <class C, class T>
Member<C, T> split(T C::*);

template <auto M>
Key value(std::string name, std::string unit, std::string sentence) {
  using Split = decltype(split(M));
  Key key;
  key.name = std::move(name);
  key.unit = std::move(unit);
  key.sentence = std::move(sentence);
  key.type = type_of<typename Split::Type>();
  key.set = [](void* spec, const Node& n) { from_node(n, static_cast<typename Split::Class*>(spec)->*M); };
  key.get = [](const void* spec) { return to_node(static_cast<const typename Split::Class*>(spec)->*M); };
  return key;
}

// One of a list of words: the values of an enumeration, in its order.
template <auto M>
Key word(std::string name, std::string sentence, std::vector<std::string> words) {
  using Split = decltype(split(M));
  using Spec = typename Split::Class;
  static const std::vector<std::string> names = words;  // one instance per key: M is part of the template
  Key key;
  key.name = std::move(name);
  key.sentence = std::move(sentence);
  key.choices = std::move(words);
  key.set = [](void* spec, const Node& n) {
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == n.text) static_cast<Spec*>(spec)->*M = static_cast<typename Split::Type>(i);
  };
  key.get = [](const void* spec) {
    return Node::of(names[static_cast<std::size_t>(static_cast<const Spec*>(spec)->*M)]);
  };
  return key;
}

template <class Spec>
std::shared_ptr<const Section> section(std::vector<Key> keys) {
  Section s;
  s.keys = std::move(keys);
  s.default_of = [](const Key& key) {
    const Spec spec{};
    return key.get(&spec);
  };
  s.where = [](void* spec) -> Where* {
    if constexpr (requires(Spec & x) { x.where; })
      return &static_cast<Spec*>(spec)->where;
    else
      return (void)spec, nullptr;
  };
  return std::make_shared<const Section>(std::move(s));
}

// [name]: a member struct.
template <auto M>
Key table(std::string name, std::string sentence, std::vector<Key> keys) {
  using Split = decltype(split(M));
  Key key;
  key.name = std::move(name);
  key.sentence = std::move(sentence);
  key.type = KeyType::table;
  key.section = section<typename Split::Type>(std::move(keys));
  key.append = [](void* spec) -> void* { return &(static_cast<typename Split::Class*>(spec)->*M); };
  key.count = [](const void*) { return std::size_t(1); };
  key.at = [](const void* spec, std::size_t) -> const void* {
    return &(static_cast<const typename Split::Class*>(spec)->*M);
  };
  return key;
}

// [name]: keys of the same struct under a heading of their own.
template <class Spec>
Key heading(std::string name, std::string sentence, std::vector<Key> keys) {
  Key key;
  key.name = std::move(name);
  key.sentence = std::move(sentence);
  key.type = KeyType::table;
  key.section = section<Spec>(std::move(keys));
  key.append = [](void* spec) { return spec; };
  key.count = [](const void*) { return std::size_t(1); };
  key.at = [](const void* spec, std::size_t) { return spec; };
  return key;
}

// [[name]]: a member vector of structs.
template <auto M>
Key tables(std::string name, std::string sentence, std::vector<Key> keys) {
  using Split = decltype(split(M));
  Key key;
  key.name = std::move(name);
  key.sentence = std::move(sentence);
  key.type = KeyType::tables;
  key.section = section<typename Split::Type::value_type>(std::move(keys));
  key.append = [](void* spec) -> void* { return &(static_cast<typename Split::Class*>(spec)->*M).emplace_back(); };
  key.count = [](const void* spec) { return (static_cast<const typename Split::Class*>(spec)->*M).size(); };
  key.at = [](const void* spec, std::size_t i) -> const void* {
    return &(static_cast<const typename Split::Class*>(spec)->*M)[i];
  };
  return key;
}

}  // namespace dem::bind
