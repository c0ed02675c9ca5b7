#pragma once
#include <string>
#include <vector>

#include "base/archive.hpp"

namespace washtub {

/// The state of an object in this rank's memory, to go back to. Takes as much memory as there is to
/// save, at its first use.
class Snapshot {
 public:
  template <class T>
  void take(T& object) {
    std::size_t needed = bytes_.size();
    do {
      if (needed > bytes_.size()) bytes_ = Bytes(), bytes_.resize(needed);
      Taker taker(bytes_);
      taker.value("", object);
      needed = taker.size();
    } while (needed > bytes_.size());
  }
  /// On return the object is as it was when take() saw it.
  template <class T>
  void put_back(T& object) {
    Giver giver(bytes_);
    giver.value("", object);
  }
  bool empty() const { return bytes_.empty(); }

 private:
  using Bytes = std::vector<std::byte>;

  class Memory : public Archive {
   public:
    explicit Memory(Bytes& bytes) : bytes_(bytes) {}

   protected:
    void enter(const std::string&) override {}
    void grid_values(const std::string& path, Number kind, void* data,
                     const GridPart& part) override {
      list(path, kind, data, part.values());
    }
    Bytes& bytes_;
    std::size_t at_ = 0;
  };
  /// Counts what it has no room for.
  class Taker final : public Memory {
   public:
    using Memory::Memory;
    bool reading() const override { return false; }
    std::size_t size() const { return at_; }

   private:
    void list(const std::string& path, Number kind, void* data, std::size_t count) override;
    std::size_t length(const std::string& path, std::size_t now) override;
  };
  class Giver final : public Memory {
   public:
    using Memory::Memory;
    bool reading() const override { return true; }

   private:
    void list(const std::string& path, Number kind, void* data, std::size_t count) override;
    std::size_t length(const std::string& path, std::size_t now) override;
  };

  Bytes bytes_;
};

}  // namespace washtub
