// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/collection.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <boost/mpi.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <chrono>
#include <thread>

namespace CGAL::Shape_correspondence::cli {
namespace {

namespace mpi = boost::mpi;

enum Tag { request, reply };

using Work = std::function<void(std::size_t)>;

// MPI's own waiting keeps a processor busy, which another process of the machine could use
constexpr std::chrono::microseconds time_between_looks(200);

/// Waits for a message without using the processor.
mpi::status awaited(const mpi::communicator& world, int source, Tag tag)
{
  for (;; std::this_thread::sleep_for(time_between_looks))
    if (const auto message = world.iprobe(source, tag)) return *message;
}

/// Waits without using the processor until all processes are here.
void await_all(const mpi::communicator& world)
{
  MPI_Request all = MPI_REQUEST_NULL;
  MPI_Ibarrier(world, &all);
  for (int are_here = 0;; std::this_thread::sleep_for(time_between_looks)) {
    MPI_Test(&all, &are_here, MPI_STATUS_IGNORE);
    if (are_here) return;
  }
}

/// The task of the first process: it answers requests for work items between its own ones.
void lead(const mpi::communicator& world, std::size_t n, const Work& work)
{
  std::size_t next = 0;
  int dismissed = 0;
  const auto serve = [&](const mpi::status& asked) {
    world.recv(asked.source(), request);
    dismissed += next >= n;
    world.send(asked.source(), reply, next < n ? next++ : n);
  };
  for (int other = 1; other < world.size(); ++other) // before this process works itself
    serve(awaited(world, other, request));
  while (next < n) {
    work(next++);
    while (const auto asked = world.iprobe(mpi::any_source, request))
      serve(*asked);
  }
  while (dismissed < world.size() - 1)
    serve(awaited(world, mpi::any_source, request));
}

/// The task of the other processes: each requests its next work item before it works on the one it has, so that the
/// reply is there when it has finished.
void follow(const mpi::communicator& world, std::size_t n, const Work& work)
{
  const auto received = [&] {
    std::size_t i = n;
    awaited(world, 0, reply);
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
  ~Mpi_team() override { await_all(world_); }

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
    await_all(world_);
    std::vector<std::string> result;
    mpi::all_gather(world_, text, result);
    return result;
  }

  std::vector<std::size_t> from_first(std::vector<std::size_t> numbers) override
  {
    await_all(world_);
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
