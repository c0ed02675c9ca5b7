#pragma once
#include <string>
#include <vector>

#include "base/archive.hpp"

namespace washtub {

/// The state of an object in this rank's memory, to go back to. Takes no more memory after its
/// first use.
class Snapshot {
 public:
  template <class T>
  void take(T& object) {
    bytes_.clear();
    Taker taker(bytes_);
    taker.value("", object);
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
  };
  class Taker final : public Memory {
   public:
    using Memory::Memory;
    bool reading() const override { return false; }

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
    std::size_t at_ = 0;
  };

  Bytes bytes_;
};

}  // namespace washtub
