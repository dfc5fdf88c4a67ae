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

/// A copy-on-write array in pages. A copy shares all pages and costs one pointer for each; a shared
/// page is copied when one of its holders writes to it. So what a revision has in common with its
/// parent stands in memory once.
///
/// Any number of threads may read; one may write to a copy while others read other copies.
template <class T>
class CowVector {
 public:
  using value_type = T;
  /// Elements per page: at most 4 KB, small enough that an edit leaves most pages alone.
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
  /// Shares each page of `alike` that holds the same values at the same indices.
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
  /// Writes unless the element is equal already, so that a shared page stays shared.
  void set(std::size_t i, const T& value) {
    if (!equal((*this)[i], value)) edit(i) = value;
  }
  /// Drops the elements from `size` on, or appends copies of `value`.
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

  /// Calls f(i, element) for all, in order: faster than iterators, which look up the page each
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
  /// Whether page k is the same memory as page k of `other`. If so, the elements that both have on
  /// it are equal.
  [[nodiscard]] bool shares(std::size_t k, const CowVector& other) const {
    return k < other.pages_.size() && pages_[k] == other.pages_[k];
  }
  /// Bytes that every page takes in memory, the last one included.
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
  /// By bytes where no padding or other representation can differ: the `==` of a std::array of a
  /// few integers would be a library call.
  static bool equal(const T& a, const T& b) {
    if constexpr (std::has_unique_object_representations_v<T>) {
      return std::memcmp(&a, &b, sizeof(T)) == 0;
    } else {
      return a == b;
    }
  }
  /// Bit for bit: 0 and -0 are equal, but not the same.
  static bool same_bits(std::span<const T> a, std::span<const T> b) {
    if constexpr (std::is_trivially_copyable_v<T>) {
      return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
    } else {
      return std::ranges::equal(a, b);
    }
  }
  /// Page k, copied first if another copy shares it.
  T* own_page(std::size_t k) {
    std::shared_ptr<T[]>& page = pages_[k];
    if (page.use_count() > 1) {
      const std::shared_ptr<T[]> shared = page;
      page = std::make_shared_for_overwrite<T[]>(kPage);
      std::copy_n(shared.get(), kPage, page.get());
    } else {
      // Orders our writes after the reads of those that gave up their share of the page.
      std::atomic_thread_fence(std::memory_order_acquire);
    }
    return page.get();
  }
  /// Appends a page with uninitialised elements.
  T* add_page() { return pages_.emplace_back(std::make_shared_for_overwrite<T[]>(kPage)).get(); }

  std::vector<std::shared_ptr<T[]>> pages_;
  std::size_t size_ = 0;
};

}  // namespace remeshd
