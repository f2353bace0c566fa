// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// After every write the two .pvd name complete moments: each file they name is there, and so is
// each piece; written in the background, they are what they are without.

#include "box_above_floor.h"
#include "scratch.h"

#include <signorini/base/user_error.h>
#include <signorini/output/field_output.h>

#include <gtest/gtest.h>

#include <regex>

using namespace signorini;

namespace
{
  /** The values of an attribute in an XML file, in order. */
  std::vector<std::string> attributes(const std::string &path, const std::string &name)
  {
    const std::string        text = contents(path);
    const std::regex         pattern("[ ]" + name + "=\"([^\"]*)\"");
    std::vector<std::string> values;
    for (auto i = std::sregex_iterator(text.begin(), text.end(), pattern);
         i != std::sregex_iterator();
         ++i)
      values.push_back((*i)[1]);
    return values;
  }

  bool names(const std::string &pvtu, const std::string &field)
  {
    const auto fields = attributes(pvtu, "Name");
    return std::find(fields.begin(), fields.end(), field) != fields.end();
  }

  void expect_complete(const std::string              &folder,
                       const std::string              &series,
                       const std::vector<std::string> &times)
  {
    const std::string pvd = folder + "/" + series + ".pvd";
    EXPECT_EQ(attributes(pvd, "timestep"), times);
    const auto files = attributes(pvd, "file");
    ASSERT_EQ(files.size(), times.size());
    for (const std::string &file : files)
      {
        const auto pieces = attributes(folder + "/" + file, "Source");
        EXPECT_EQ(pieces.size(), dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
        for (const std::string &piece : pieces)
          EXPECT_NE(contents(folder + "/fields/" + piece).find("</VTKFile>"), std::string::npos)
            << piece;
      }
    for (const auto &entry : std::filesystem::directory_iterator(folder + "/fields"))
      EXPECT_NE(entry.path().extension(), ".part");
  }

  template <int dim>
  State state_at_rest(const Discretization<dim> &discretization)
  {
    State state;
    state.displacement = state.velocity = state.contact_force = discretization.make_vector();
    return state;
  }

  template <int dim>
  void write_two_moments(const bool in_background)
  {
    const ScratchFolder      folder;
    const BoxAboveFloor<dim> box;
    FieldOutput<dim>         output(folder.name, MPI_COMM_WORLD, in_background);
    State                    state = state_at_rest(box.discretization);
    output.write(state, box.discretization, *box.surface);
    EXPECT_EQ(output.is_writing(), in_background);
    output.finish();
    EXPECT_FALSE(output.is_writing());
    MPI_Barrier(MPI_COMM_WORLD);
    expect_complete(folder.name, "volume", {"0"});
    expect_complete(folder.name, "surface", {"0"});
    MPI_Barrier(MPI_COMM_WORLD);

    state.step = 7;
    state.time = 0.123456789012;
    output.write(state, box.discretization, *box.surface);
    output.write(state, box.discretization, *box.surface);
    while (output.is_writing())
      output.finish_if_written();
    MPI_Barrier(MPI_COMM_WORLD);
    expect_complete(folder.name, "volume", {"0", "0.123456789012"});
    expect_complete(folder.name, "surface", {"0", "0.123456789012"});

    const std::string volume = folder.name + "/fields/volume_000007.pvtu";
    for (const char *field : {"displacement",
                              "velocity",
                              "body",
                              "von_mises",
                              "stress_xx",
                              "stress_yy",
                              "stress_zz",
                              "stress_xy",
                              "subdomain"})
      EXPECT_TRUE(names(volume, field)) << field;
    EXPECT_EQ(names(volume, "stress_yz"), dim == 3);
    const std::string surface = folder.name + "/fields/surface_000007.pvtu";
    for (const char *field : {"displacement", "velocity", "CPRESS", "COPEN", "CSTATUS"})
      EXPECT_TRUE(names(surface, field)) << field;
    for (const char *field : {"CSHEAR", "CSLIP", "CSLIP_INCREMENT"})
      EXPECT_FALSE(names(surface, field)) << field;
  }
} // namespace

TEST(FieldOutput, TwoMoments)
{
  for (const bool in_background : {false, true})
    {
      write_two_moments<2>(in_background);
      write_two_moments<3>(in_background);
    }
}

TEST(FieldOutput, VectorsOfFriction)
{
  const ScratchFolder    folder;
  const BoxAboveFloor<2> box(true);
  FieldOutput<2>         output(folder.name, MPI_COMM_WORLD);
  output.write(state_at_rest(box.discretization), box.discretization, *box.surface);
  output.finish();
  MPI_Barrier(MPI_COMM_WORLD);
  const std::string surface = folder.name + "/fields/surface_000000.pvtu";
  for (const char *field : {"CSTATUS", "CSHEAR", "CSLIP", "CSLIP_INCREMENT"})
    EXPECT_TRUE(names(surface, field)) << field;
  const auto components = attributes(surface, "NumberOfComponents");
  EXPECT_EQ(std::count(components.begin(), components.end(), "3"), 6)
    << "points, motion and the three vectors";
}

// Pictures of an earlier run must not pass for those of this one.
TEST(FieldOutput, NoPairsNoSurface)
{
  const ScratchFolder folder;
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::ofstream(folder.name + "/surface.pvd") << "old";
  Scene<2> scene = box_above_floor<2>();
  scene.pairs.clear();
  const Mesh<2>                mesh(scene.bodies, MPI_COMM_WORLD);
  const Discretization<2>      discretization(mesh);
  const DirichletConditions<2> dirichlet(discretization);
  const ContactSurface<2>      surface(discretization, dirichlet, scene.obstacles, scene.pairs);
  FieldOutput<2>               output(folder.name, MPI_COMM_WORLD);
  output.write(state_at_rest(discretization), discretization, surface);
  output.finish();
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_TRUE(std::filesystem::exists(folder.name + "/volume.pvd"));
  EXPECT_FALSE(std::filesystem::exists(folder.name + "/surface.pvd"));
}

// A folder that vanishes during the run ends it with an error on all processes, and not with an
// abort inside of deal.II. No .pvd names the moment, and it can be written once more.
TEST(FieldOutput, FolderVanishes)
{
  for (const bool in_background : {false, true})
    {
      const ScratchFolder    folder;
      const BoxAboveFloor<2> box;
      FieldOutput<2>         output(folder.name, MPI_COMM_WORLD, in_background);
      State                  state = state_at_rest(box.discretization);
      output.write(state, box.discretization, *box.surface);
      output.finish();
      const std::string fields  = folder.name + "/fields";
      const auto        replace = [](const std::string &from, const std::string &to) {
        MPI_Barrier(MPI_COMM_WORLD);
        if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
          std::filesystem::rename(from, to);
        MPI_Barrier(MPI_COMM_WORLD);
      };
      replace(fields, fields + "_away");
      state.step = 3;
      state.time = 0.5;
      try
        {
          output.write(state, box.discretization, *box.surface);
          output.finish();
          FAIL() << "the failure was not noticed";
        }
      catch (const RunError &error)
        {
          EXPECT_NE(std::string(error.what()).find("cannot write `" + fields + "/volume_000003.0"),
                    std::string::npos)
            << error.what();
        }
      EXPECT_FALSE(output.is_writing());
      EXPECT_EQ(attributes(folder.name + "/volume.pvd", "timestep").size(), 1u);
      replace(fields + "_away", fields);
      output.write(state, box.discretization, *box.surface);
      output.finish();
      MPI_Barrier(MPI_COMM_WORLD);
      expect_complete(folder.name, "volume", {"0", "0.5"});
    }
}

// The thread that writes neither sees nor keeps the mesh and the state of the run.
TEST(FieldOutput, BackgroundWritesTheSame)
{
  std::vector<std::string> written;
  for (const bool in_background : {false, true})
    {
      const ScratchFolder folder;
      FieldOutput<3>      output(folder.name, MPI_COMM_WORLD, in_background);
      {
        const BoxAboveFloor<3> box;
        State                  state = state_at_rest(box.discretization);
        state.displacement = box.discretization.interpolate({{{"0.1*x*y", "0.2*z", "0.3*x*z"}}});
        output.write(state, box.discretization, *box.surface);
      }
      output.finish();
      MPI_Barrier(MPI_COMM_WORLD);
      std::string files;
      for (const char *series : {"volume", "surface"})
        files += contents(folder.name + "/fields/" + series + "_000000."
                          + std::to_string(dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD))
                          + ".vtu");
      written.push_back(std::regex_replace(files, std::regex("#This file was generated.*"), ""));
    }
  EXPECT_GT(written[0].size(), 1000u);
  EXPECT_EQ(written[0], written[1]);
}

TEST(FieldOutput, FolderCannotBeMade)
{
  const BoxAboveFloor<2> box;
  EXPECT_THROW(FieldOutput<2>("/dev/null/results", MPI_COMM_WORLD), RunError);
}
