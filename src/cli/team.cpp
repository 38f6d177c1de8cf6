// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/team.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#ifdef SHAPE_CORRESPONDENCE_WITH_MPI
#include <boost/mpi.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/vector.hpp>

#include <cstdlib>
#endif

namespace CGAL::Shape_correspondence::cli {
#ifdef SHAPE_CORRESPONDENCE_WITH_MPI

namespace mpi = boost::mpi;

struct Team::Impl
{
  mpi::environment environment{/* abort_on_exception = */ false};
  mpi::communicator world;
};

namespace {

enum Tag { request, reply };

/// MPI is started under `mpirun` only, where it has something to do.
bool is_under_mpirun()
{
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMI_RANK", "PMIX_RANK"})
    if (std::getenv(variable)) return true;
  return false;
}

/// The work of one process, of which a failure is kept for all to know.
class Kept_work
{
public:
  explicit Kept_work(const std::function<void(std::size_t)>& work) : work_(work) {}

  void operator()(std::size_t i)
  {
    if (!failure_.empty()) return;
    try {
      work_(i);
    } catch (const std::bad_alloc&) {
      failure_ = "there is not enough memory";
    } catch (const std::exception& error) {
      failure_ = error.what();
    }
  }

  const std::string& failure() const { return failure_; }

private:
  const std::function<void(std::size_t)>& work_;
  std::string failure_;
};

/// The first process hands out numbers whenever it is between two of its own.
void lead(const mpi::communicator& world, std::size_t n, Kept_work& work)
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

/// The others ask for the next number before they begin with one, so that they need not wait for it.
void follow(const mpi::communicator& world, std::size_t n, Kept_work& work)
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

} // namespace

Team::Team()
{
  if (!is_under_mpirun()) return;
  impl_ = std::make_unique<Impl>();
  if (impl_->world.size() == 1) impl_.reset();
}

std::size_t Team::size() const { return impl_ ? std::size_t(impl_->world.size()) : 1; }

bool Team::is_first() const { return !impl_ || impl_->world.rank() == 0; }

std::size_t Team::size_here() const
{
  if (!impl_) return 1;
  MPI_Comm here = MPI_COMM_NULL;
  MPI_Comm_split_type(impl_->world, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
  return std::size_t(mpi::communicator(here, mpi::comm_take_ownership).size());
}

void Team::for_each(std::size_t n, const std::function<void(std::size_t)>& work)
{
  if (!impl_) {
    for (std::size_t i = 0; i < n; ++i)
      work(i);
    return;
  }
  Kept_work kept(work);
  is_first() ? lead(impl_->world, n, kept) : follow(impl_->world, n, kept);
  for (const std::string& failure : gathered(kept.failure()))
    if (!failure.empty()) throw Invalid_input(failure);
}

std::vector<std::string> Team::gathered(const std::string& text)
{
  if (!impl_) return {text};
  std::vector<std::string> result;
  mpi::all_gather(impl_->world, text, result);
  return result;
}

std::vector<std::size_t> Team::from_first(std::vector<std::size_t> numbers)
{
  if (impl_) mpi::broadcast(impl_->world, numbers, 0);
  return numbers;
}

#else

struct Team::Impl
{};

Team::Team() = default;

std::size_t Team::size() const { return 1; }

bool Team::is_first() const { return true; }

std::size_t Team::size_here() const { return 1; }

void Team::for_each(std::size_t n, const std::function<void(std::size_t)>& work)
{
  for (std::size_t i = 0; i < n; ++i)
    work(i);
}

std::vector<std::string> Team::gathered(const std::string& text) { return {text}; }

std::vector<std::size_t> Team::from_first(std::vector<std::size_t> numbers) { return numbers; }

#endif

Team::~Team() = default;

} // namespace CGAL::Shape_correspondence::cli
