// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/collection.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <boost/mpi.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

namespace CGAL::Shape_correspondence::cli {
namespace {

namespace mpi = boost::mpi;

enum Tag { request, reply };

using Work = std::function<void(std::size_t)>;

/// The first process answers requests between its own work items.
void lead(const mpi::communicator& world, std::size_t n, const Work& work)
{
  std::size_t next = 0;
  int dismissed = 0;
  const auto serve = [&](const mpi::status& asked) {
    world.recv(asked.source(), request);
    dismissed += next >= n;
    world.send(asked.source(), reply, next < n ? next++ : n);
  };
  while (next < n) {
    work(next++);
    while (const auto asked = world.iprobe(mpi::any_source, request))
      serve(*asked);
  }
  while (dismissed < world.size() - 1)
    serve(world.probe(mpi::any_source, request));
}

/// The others request the next number before they start on one, so that they need not wait for it.
void follow(const mpi::communicator& world, std::size_t n, const Work& work)
{
  const auto received = [&] {
    std::size_t i = n;
    world.recv(0, reply, i);
    return i;
  };
  world.send(0, request);
  for (std::size_t i = received(); i < n; i = received()) {
    world.send(0, request);
    work(i);
  }
}

class Mpi_team : public Team
{
public:
  std::size_t size() const override { return std::size_t(world_.size()); }
  bool is_first() const override { return world_.rank() == 0; }

  std::size_t size_here() const override
  {
    MPI_Comm here = MPI_COMM_NULL;
    MPI_Comm_split_type(world_, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
    return std::size_t(mpi::communicator(here, mpi::comm_take_ownership).size());
  }

  void for_each(std::size_t n, const Work& work) override
  {
    std::string own_failure; // kept until all processes are told
    const Work kept = [&](std::size_t i) {
      if (!own_failure.empty()) return;
      try {
        work(i);
      } catch (const std::bad_alloc&) {
        own_failure = "there is not enough memory";
      } catch (const std::exception& error) {
        own_failure = error.what();
      }
    };
    is_first() ? lead(world_, n, kept) : follow(world_, n, kept);
    for (const std::string& failure : gathered(own_failure))
      if (!failure.empty()) throw Invalid_input(failure);
  }

  std::vector<std::string> gathered(const std::string& text) override
  {
    std::vector<std::string> result;
    mpi::all_gather(world_, text, result);
    return result;
  }

  std::vector<std::size_t> from_first(std::vector<std::size_t> numbers) override
  {
    mpi::broadcast(world_, numbers, 0);
    return numbers;
  }

private:
  mpi::environment environment_{/* abort_on_exception = */ false};
  mpi::communicator world_;
};

[[maybe_unused]] const bool is_set = [] {
  make_team = []() -> std::unique_ptr<Team> { return std::make_unique<Mpi_team>(); };
  return true;
}();

} // namespace
} // namespace CGAL::Shape_correspondence::cli
