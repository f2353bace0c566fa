// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/base/user_error.h>
#include <signorini/checkpoint/mesh_levels.h>
#include <signorini/checkpoint/scene_changes.h>
#include <signorini/checkpoint/shared_file.h>
#include <signorini/output/provenance.h>
#include <signorini/output/whole_file.h>
#include <signorini/simulation/change_mesh.h>
#include <signorini/simulation/simulation.h>

#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** The files of a checkpoint. */
    const char *const scene_file = "scene", *const mesh_file = "mesh",
                      *const memory_file = "memory", *const vector_file = "vector_";

    std::string vector_path(const std::string &folder, const std::size_t number)
    {
      return folder + "/" + vector_file + std::to_string(number);
    }


    /** Entries of this process, and where they are in the file. */
    std::pair<std::size_t, std::uint64_t> part_of(const Vector &vector)
    {
      return {vector.locally_owned_size() * sizeof(double),
              vector.get_partitioner()->local_range().first * sizeof(double)};
    }


    /** Checksums of the meshes that a scene reads. */
    template <int dim>
    std::map<std::string, std::uint32_t> checksums(const Scene<dim> &scene)
    {
      std::map<std::string, std::uint32_t> sums;
      for (const auto &[key, path] : scene.input_files)
        sums[key] = checksum(path);
      return sums;
    }


    /** @throws UserError if one of them is not what it was */
    template <int dim>
    void check_files(Archive &archive, const Scene<dim> &scene)
    {
      std::map<std::string, std::uint32_t> then;
      archive(then);
      for (const auto &[key, sum] : checksums(scene))
        if (then.at(key) != sum)
          throw UserError("the file of `" + key
                          + "` has changed since the checkpoint was written. Put it back, or run "
                            "without --resume.");
    }


    std::string content_of(const std::string &path)
    {
      std::ifstream file(path, std::ios::binary);
      return {std::istreambuf_iterator<char>(file), {}};
    }
  } // namespace


  template <int dim>
  bool Simulation<dim>::is_checkpoint(const bool at_end)
  {
    const CheckpointParameters &wanted = scene.checkpoint;
    if (at_end)
      return wanted.any(); // so that the run can go on beyond its end
    if (wanted.every_steps > 0 && state.step % wanted.every_steps == 0)
      return true;
    if (wanted.every_minutes == 0.)
      return false;
    const bool is_due = since_checkpoint.wall_time() >= 60. * wanted.every_minutes;
    return Utilities::MPI::broadcast(mesh.communicator(), is_due, 0);
  }


  template <int dim>
  void Simulation<dim>::keep_checkpoints(TimeStepping     &stepping,
                                         Observation<dim> &observation,
                                         Interruption     &interruption)
  {
    const bool at_end         = stepping.finished(state);
    const bool is_told_to_end = !at_end && interruption.is_wanted(mesh.communicator());
    if (is_told_to_end || is_checkpoint(at_end))
      {
        PackedState packed(state, meshed->surface);
        write_checkpoint(packed, stepping, observation);
        if (!at_end && !is_told_to_end)
          begin_anew(packed, stepping, observation);
      }
    if (is_told_to_end)
      interruption.end(state.time, how_to_go_on());
  }


  template <int dim>
  StepReport Simulation<dim>::advance_or_leave(TimeStepping     &stepping,
                                               Observation<dim> &observation,
                                               Interruption     &interruption)
  {
    try
      {
        return advance(stepping, observation);
      }
    catch (const StepAbandoned &)
      {
        meshed->take_contact_back(state);
        PackedState packed(state, meshed->surface);
        write_checkpoint(packed, stepping, observation);
        interruption.is_wanted(mesh.communicator()); // which signal
        interruption.end(state.time, "The next step takes long and was left. " + how_to_go_on());
      }
  }


  template <int dim>
  std::string Simulation<dim>::how_to_go_on() const
  {
    std::string command = "signorini --resume " + scene.file_name;
    for (const auto &[key, value] : scene.overrides)
      command += " --set \"" + key + "=" + value + "\"";
    return "To go on: " + command;
  }


  template <int dim>
  void Simulation<dim>::write_checkpoint(PackedState      &packed,
                                         TimeStepping     &stepping,
                                         Observation<dim> &observation)
  {
    TimerOutput::Scope scope(timer, "checkpoint");
    complete_fields(observation, true);
    checkpoints.write([&](const std::string &folder) {
      if (mesh_control.any())
        write_levels(mesh, folder + "/" + mesh_file);
      for (std::size_t i = 0; i < packed.everywhere.size(); ++i)
        {
          const Vector &vector       = packed.everywhere[i];
          const auto [length, place] = part_of(vector);
          write_parts(vector_path(folder, i), vector.begin(), length, place, mesh.communicator());
        }
      std::ostringstream memory;
      Archive            archive(memory);
      auto               sums = checksums(scene);
      archive(sums);
      mesh_control.archive(archive);
      packed.archive(archive, state.displacement);
      this->archive(archive, stepping, observation);
      succeed_together(mesh.communicator(), [&] {
        if (Utilities::MPI::this_mpi_process(mesh.communicator()) != 0)
          return;
        write_whole_file(folder + "/" + memory_file,
                         [&](std::ostream &out) { out << memory.str(); });
        write_whole_file(folder + "/" + scene_file,
                         [&](std::ostream &out) { out << scene.all_parameters; });
      });
    });
    since_checkpoint.restart();
  }


  template <int dim>
  void Simulation<dim>::begin_anew(const PackedState &packed,
                                   TimeStepping      &stepping,
                                   Observation<dim>  &observation)
  {
    build_anew(scene, mesh_control.mesh_life_time(), meshed, timer);
    mesh_control.mesh_is_made_anew();
    stepping.forget();
    scheme->forget();
    mesh_has_just_changed = true;
    go_on_with(packed, observation);
  }


  template <int dim>
  void Simulation<dim>::go_on_with(const PackedState &packed, Observation<dim> &observation)
  {
    state = State(); // see change_mesh()
    state = packed.unpack(meshed->surface, meshed->system);
    observation.go_on(*meshed, state);
  }


  template <int dim>
  void
  Simulation<dim>::archive(Archive &archive, TimeStepping &stepping, Observation<dim> &observation)
  {
    MotionEnergies energies = meshed->system.energies();
    ProductCount   products = meshed->discretization.matrices().products();
    archive(energies.motion, energies.elastic, products, latest_interval);
    if (archive.reads())
      {
        meshed->system.see(energies);
        meshed->discretization.matrices().set_products(products);
      }
    stepping.archive(archive);
    observation.archive(archive);
    if (fields)
      fields->archive(archive);
    if (moving_obstacles)
      moving_obstacles->archive(archive);
  }


  template <int dim>
  void Simulation<dim>::check_scene(const std::string &checkpoint) const
  {
    const std::vector<std::string> changes =
      forbidden_changes(content_of(checkpoint + "/" + scene_file), scene.all_parameters);
    if (!changes.empty())
      throw UserError("the scene is not that of the checkpoint: " + join(changes, "; ")
                      + ". Change it back, or run it without --resume. What may change: "
                      + keys_that_may_change() + ".");
  }


  template <int dim>
  void Simulation<dim>::resume()
  {
    // A folder is not made for the lock of a run that cannot be.
    CheckpointFolder::Found found = checkpoints.find();
    if (found.folder.empty())
      throw UserError("there is no checkpoint to go on from: " + join(found.rejected, "; ")
                      + ". Run without --resume.");
    const FolderLock lock(scene.output_directory, mesh.communicator());
    found = checkpoints.find(); // a run that was ending may have left another one
    check_scene(found.folder);
    std::istringstream memory(content_of(found.folder + "/" + memory_file));
    Archive            archive(memory);
    check_files(archive, scene);
    if (mesh_control.any())
      restore_levels(mesh, found.folder + "/" + mesh_file);
    mesh_control.archive(archive); // it tells what is built how long it will live
    PackedState packed;
    meshed = std::make_unique<MeshedScene<dim>>(mesh, scene, mesh_control.mesh_life_time(), timer);
    packed.archive(archive, meshed->discretization.make_vector());
    for (std::size_t i = 0; i < packed.everywhere.size(); ++i)
      {
        Vector &vector             = packed.everywhere[i];
        const auto [length, place] = part_of(vector);
        read_part(vector_path(found.folder, i), vector.begin(), length, place);
      }
    RunLog log(scene.output_directory, quiet, mesh.communicator(), true);
    for (const std::string &wrong : found.rejected)
      log.warning(wrong + "; an earlier checkpoint is used.");
    begin_fields();
    Observation<dim> observation(scene, *meshed);
    const auto       stepping = make_stepping();
    this->archive(archive, *stepping, observation);
    go_on_with(packed, observation);
    log.record(
      provenance(scene.file_name, scene.overrides, scene.input_files, mesh.communicator()));
    log.message("The run goes on from `" + found.folder + "`: step " + std::to_string(state.step)
                + ", time " + Patterns::Tools::to_string(state.time) + ".");
    if (!stepping->finished(state))
      return go_to_the_end(*stepping, observation, log);
    log.message("It had come to its end. Give a later `Time/End time` to go on.");
    log.finish();
  }


#define INSTANTIATE(dim)                                                                           \
  template void       Simulation<dim>::resume();                                                   \
  template StepReport Simulation<dim>::advance_or_leave(                                           \
    TimeStepping &, Observation<dim> &, Interruption &);                                           \
  template void Simulation<dim>::keep_checkpoints(                                                 \
    TimeStepping &, Observation<dim> &, Interruption &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
