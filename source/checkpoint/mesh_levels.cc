// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/checkpoint/mesh_levels.h>
#include <signorini/checkpoint/shared_file.h>

#include <deal.II/grid/cell_id.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    /** More repetitions than levels mean that the file belongs to another mesh. */
    constexpr unsigned int most_levels = 64;

    /** The cells that have children, from the levels of those that have none. */
    class RefinedCells
    {
    public:
      template <int dim>
      RefinedCells(const parallel::distributed::Triangulation<dim> &cells,
                   std::vector<std::uint8_t>                        levels)
        : levels(std::move(levels))
        , n_children(1 << dim)
      {
        // A coarse cell has the number of its tree in its CellId.
        const unsigned int n_trees = cells.n_cells(0);
        for (unsigned int tree = 0; tree < n_trees; ++tree)
          {
            std::vector<std::uint8_t> path;
            visit(tree, path);
          }
        is_whole = is_whole && next == this->levels.size();
      }

      bool contain(const CellId &id) const { return refined.count(id) > 0; }

      /** Whether the levels are those of a refinement of the coarse mesh. */
      bool are_consistent() const { return is_whole; }

    private:
      const std::vector<std::uint8_t> levels;
      const unsigned int              n_children;
      std::size_t                     next     = 0;
      bool                            is_whole = true;
      std::set<CellId>                refined;

      void visit(const types::coarse_cell_id coarse, std::vector<std::uint8_t> &path)
      {
        is_whole = is_whole && next < levels.size() && path.size() <= levels[next];
        if (!is_whole || path.size() == levels[next])
          {
            ++next;
            return;
          }
        refined.emplace(coarse, path);
        for (unsigned int child = 0; child < n_children; ++child)
          {
            path.push_back(child);
            visit(coarse, path);
            path.pop_back();
          }
      }
    };


    /** Flag what is not as it should be. @return whether there was anything on any process */
    template <int dim>
    bool set_flags_of_levels(const Mesh<dim> &mesh, const RefinedCells &refined)
    {
      bool any = false;
      for (const auto &cell : mesh.active_cells())
        if (cell->is_locally_owned())
          {
            if (refined.contain(cell->id()))
              cell->set_refine_flag();
            else if (cell->level() > 0 && !refined.contain(cell->parent()->id()))
              cell->set_coarsen_flag();
            else
              continue;
            any = true;
          }
      return Utilities::MPI::max(any ? 1 : 0, mesh.communicator()) == 1;
    }
  } // namespace


  template <int dim>
  void write_levels(const Mesh<dim> &mesh, const std::string &path)
  {
    std::vector<std::uint8_t> levels;
    for (const auto &cell : mesh.active_cells())
      if (cell->is_locally_owned())
        levels.push_back(static_cast<std::uint8_t>(cell->level()));
    const std::uint64_t n     = levels.size();
    std::uint64_t       place = 0;
    MPI_Exscan(&n, &place, 1, MPI_UINT64_T, MPI_SUM, mesh.communicator());
    write_parts(path, levels.data(), levels.size(), place, mesh.communicator());
  }


  template <int dim>
  void restore_levels(Mesh<dim> &mesh, const std::string &path)
  {
    std::vector<std::uint8_t> levels(std::filesystem::file_size(path));
    read_part(path, levels.data(), levels.size(), 0);
    const RefinedCells refined(mesh.triangulation(), std::move(levels));
    unsigned int       n_changes = 0;
    while (set_flags_of_levels(mesh, refined) && ++n_changes < most_levels)
      mesh.carry_out_flags();
    if (!refined.are_consistent() || n_changes == most_levels)
      throw RunError("`" + path + "` is not a mesh of this scene.");
  }


#define INSTANTIATE(dim)                                                                           \
  template void write_levels(const Mesh<dim> &, const std::string &);                              \
  template void restore_levels(Mesh<dim> &, const std::string &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace signorini
