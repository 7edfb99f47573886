// A list that lives on the stack while it is short and moves to the heap when it outgrows N: what a query collects
// about bodies of any number of corners without allocating for the usual ones.
#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

namespace contact {

template <class T, std::size_t N>
class ShortList {
 public:
  void push_back(const T& v) {
    if (size_ < N) {
      near_.list[size_++] = v;
      return;
    }
    if (size_ == N) far_.assign(near_.list, near_.list + N);
    far_.push_back(v);
    ++size_;
  }
  void assign(std::size_t count, const T& v) {
    clear();
    for (std::size_t i = 0; i < count; ++i) push_back(v);
  }
  void clear() {
    size_ = 0;
    far_.clear();
  }
  std::size_t size() const { return size_; }
  T* begin() { return size_ <= N ? near_.list : far_.data(); }
  T* end() { return begin() + size_; }
  const T* begin() const { return size_ <= N ? near_.list : far_.data(); }
  const T* end() const { return begin() + size_; }
  T& operator[](std::size_t i) { return begin()[i]; }
  const T& operator[](std::size_t i) const { return begin()[i]; }

 private:
  static_assert(std::is_trivially_copyable_v<T>);
  // Without initial values: clearing what is never read costs more than a short list itself.
  union Near {
    Near() {}  // NOLINT(modernize-use-equals-default): that would be deleted
    T list[N];
  };
  Near near_;
  std::vector<T> far_;
  std::size_t size_ = 0;
};

}  // namespace contact
