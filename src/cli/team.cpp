// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/team.h"
#include "cli/Option_table.h"

#include <cstdlib>

namespace CGAL::Shape_correspondence::cli {
namespace {

/// Refuses to be one of several processes, each of which would do all the work.
std::unique_ptr<Team> this_process()
{
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) // of Open MPI, of MPICH
    if (const char* size = std::getenv(variable); size && std::atoi(size) > 1)
      throw Usage_error("to share the work among processes, `mpirun` takes the program shape_correspondence_mpi, which "
                        "is built with -DSHAPE_CORRESPONDENCE_MPI=ON");
  return std::make_unique<Team>();
}

} // namespace

std::unique_ptr<Team> (*make_team)() = this_process;

} // namespace CGAL::Shape_correspondence::cli
