#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace remeshd {

/// An array in pages that its copies share: a copy costs a pointer a page, and a page is copied
/// when somebody writes to it who is not alone with it. So what a revision has of its parent's
/// stands in memory once.
///
/// Reading is safe from any number of threads, as is writing to one copy while others are read.
template <class T>
class CowVector {
 public:
  using value_type = T;
  /// Elements of a page: some 4 KB, small enough that an edit leaves most of them alone.
  static constexpr std::size_t kPage = std::bit_floor(std::size_t{4096} / sizeof(T));

  /// Random access.
  class Iterator {
   public:
    using iterator_category = std::random_access_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = const T*;
    using reference = const T&;

    Iterator() = default;
    Iterator(const CowVector& pages, std::size_t at) : pages_(&pages), at_(at) {}

    reference operator*() const { return (*pages_)[at_]; }
    pointer operator->() const { return &(*pages_)[at_]; }
    reference operator[](difference_type by) const { return *(*this + by); }
    Iterator& operator+=(difference_type by) {
      at_ += static_cast<std::size_t>(by);
      return *this;
    }
    Iterator& operator-=(difference_type by) { return *this += -by; }
    Iterator& operator++() { return *this += 1; }
    Iterator& operator--() { return *this += -1; }
    Iterator operator++(int) { return std::exchange(*this, *this + 1); }
    Iterator operator--(int) { return std::exchange(*this, *this - 1); }
    friend Iterator operator+(Iterator a, difference_type by) { return a += by; }
    friend Iterator operator+(difference_type by, Iterator a) { return a += by; }
    friend Iterator operator-(Iterator a, difference_type by) { return a -= by; }
    friend difference_type operator-(const Iterator& a, const Iterator& b) {
      return static_cast<difference_type>(a.at_) - static_cast<difference_type>(b.at_);
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.at_ == b.at_; }
    friend auto operator<=>(const Iterator& a, const Iterator& b) { return a.at_ <=> b.at_; }

   private:
    const CowVector* pages_ = nullptr;
    std::size_t at_ = 0;
  };

  CowVector() = default;
  explicit CowVector(std::span<const T> values) {
    for (std::size_t begin = 0; begin < values.size(); begin += kPage) {
      const std::span<const T> some = values.subspan(begin, std::min(kPage, values.size() - begin));
      std::ranges::copy(some, add_page());
    }
    size_ = values.size();
  }
  explicit CowVector(const std::vector<T>& values) : CowVector(std::span<const T>(values)) {}
  /// Shares the pages of `alike` that are the same.
  CowVector(std::span<const T> values, const CowVector& alike) {
    for (std::size_t begin = 0; begin < values.size(); begin += kPage) {
      const std::span<const T> some = values.subspan(begin, std::min(kPage, values.size() - begin));
      const std::size_t k = begin / kPage;
      if (k < alike.pages() && same_bits(some, alike.page(k))) {
        pages_.push_back(alike.pages_[k]);
      } else {
        std::ranges::copy(some, add_page());
      }
    }
    size_ = values.size();
  }
  CowVector(std::size_t size, const T& value) { resize(size, value); }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  const T& operator[](std::size_t i) const { return pages_[i / kPage][i % kPage]; }
  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  [[nodiscard]] Iterator end() const { return {*this, size_}; }

  /// An element to write to.
  T& edit(std::size_t i) { return own_page(i / kPage)[i % kPage]; }
  /// The elements of a page, to write to.
  std::span<T> edit_page(std::size_t k) {
    return {own_page(k), std::min(kPage, size_ - k * kPage)};
  }
  /// Writes, where that is not what stands there.
  void set(std::size_t i, const T& value) {
    if (!equal((*this)[i], value)) edit(i) = value;
  }
  /// Leaves out what is beyond, or adds `value`.
  void resize(std::size_t size, const T& value = {}) {
    while (size_ < size && size_ % kPage != 0) edit(size_++) = value;
    pages_.resize(std::min(pages_.size(), (size + kPage - 1) / kPage));
    if (size_ < size) {
      std::fill_n(add_page(), kPage, value);
      while (pages_.size() * kPage < size) pages_.push_back(pages_.back());
    }
    size_ = size;
  }

  void push_back(const T& value) { resize(size_ + 1, value); }

  /// Calls f(i, element) for all, in order: faster than by iterators, which look a page up each
  /// time.
  template <class F>
  void for_each(F&& f) const {
    for (std::size_t k = 0, i = 0; k < pages(); ++k)
      for (const T& value : page(k)) f(i++, value);
  }

  [[nodiscard]] std::size_t pages() const { return pages_.size(); }
  /// The elements of a page.
  [[nodiscard]] std::span<const T> page(std::size_t k) const {
    return {pages_[k].get(), std::min(kPage, size_ - k * kPage)};
  }
  /// Whether this is the same memory as another's page: nothing differs.
  [[nodiscard]] bool shares(std::size_t k, const CowVector& other) const {
    return k < other.pages_.size() && pages_[k] == other.pages_[k];
  }
  /// Memory of a page, as a whole.
  static constexpr std::size_t page_bytes() { return kPage * sizeof(T); }

  [[nodiscard]] std::vector<T> flat() const {
    std::vector<T> values;
    values.reserve(size_);
    for (std::size_t k = 0; k < pages(); ++k)
      values.insert(values.end(), page(k).begin(), page(k).end());
    return values;
  }

  friend bool operator==(const CowVector& a, const CowVector& b) {
    if (a.size_ != b.size_) return false;
    for (std::size_t k = 0; k < a.pages(); ++k)
      if (!a.shares(k, b) && !std::ranges::equal(a.page(k), b.page(k))) return false;
    return true;
  }

 private:
  /// The arrays that `==` compares by a call, for their few bytes, are compared in place.
  static bool equal(const T& a, const T& b) {
    if constexpr (std::has_unique_object_representations_v<T>) {
      return std::memcmp(&a, &b, sizeof(T)) == 0;
    } else {
      return a == b;
    }
  }
  /// 0 and -0 are equal, and not the same.
  static bool same_bits(std::span<const T> a, std::span<const T> b) {
    if constexpr (std::is_trivially_copyable_v<T>) {
      return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
    } else {
      return std::ranges::equal(a, b);
    }
  }
  /// A page, which no other shares from now on.
  T* own_page(std::size_t k) {
    std::shared_ptr<T[]>& page = pages_[k];
    if (page.use_count() > 1) {
      const std::shared_ptr<T[]> shared = page;
      page = std::make_shared_for_overwrite<T[]>(kPage);
      std::copy_n(shared.get(), kPage, page.get());
    } else {
      // Whoever left it to us has done reading.
      std::atomic_thread_fence(std::memory_order_acquire);
    }
    return page.get();
  }
  /// Its elements have no values yet.
  T* add_page() { return pages_.emplace_back(std::make_shared_for_overwrite<T[]>(kPage)).get(); }

  std::vector<std::shared_ptr<T[]>> pages_;
  std::size_t size_ = 0;
};

}  // namespace remeshd
