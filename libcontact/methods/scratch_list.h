// A list in the scratch of a thread: room is made once for all that a loop may add, and adding asks no more.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

namespace contact {

template <class T>
class ScratchList {
 public:
  // Keeps the first `kept` entries.
  void make_room(std::size_t count, std::size_t kept = 0) {
    if (count <= room_) return;
    room_ = count < 64 ? 64 : 2 * count;
    std::unique_ptr<T[]> larger(new T[room_]);
    std::copy_n(data_.get(), kept, larger.get());
    data_ = std::move(larger);
  }
  T* data() { return data_.get(); }
  const T* data() const { return data_.get(); }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }

 private:
  std::unique_ptr<T[]> data_;
  std::size_t room_ = 0;
};

}  // namespace contact
