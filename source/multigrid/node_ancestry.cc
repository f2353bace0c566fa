// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/discretization/cell_id_hash.h>
#include <signorini/multigrid/node_ancestry.h>

#include <Eigen/Dense>

#include <deal.II/base/mpi.h>

#include <array>
#include <set>
#include <unordered_map>

namespace signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Cell = typename DoFHandler<dim>::cell_iterator;

    constexpr unsigned int not_a_child = numbers::invalid_unsigned_int;
    constexpr double       negligible  = 1e-8; ///< distance from the middle, in diameters

    /** Number of a child among its brothers, which is the number of the vertex that they share. */
    template <int dim>
    unsigned int number_of_child(const Cell<dim> &cell)
    {
      const auto parent = cell->parent();
      for (unsigned int c = 0; c < GeometryInfo<dim>::max_children_per_cell; ++c)
        if (parent->child(c) == cell)
          return c;
      return not_a_child;
    }


    /** A vertex of a refined cell in the words of all processes. */
    struct VertexName
    {
      CellId::binary_type cell;
      unsigned int        vertex;

      bool operator==(const VertexName &other) const
      {
        return cell == other.cell && vertex == other.vertex;
      }

      template <class Archive>
      void serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &cell &vertex;
      }
    };

    struct VertexNameHash
    {
      std::size_t operator()(const VertexName &name) const
      {
        std::size_t seed = boost::hash_range(name.cell.begin(), name.cell.end());
        boost::hash_combine(seed, name.vertex);
        return seed;
      }
    };


    template <int dim>
    using Weights = std::array<double, GeometryInfo<dim>::vertices_per_cell>;

    /**
     * On a curved boundary a new node does not lie in the middle. The smallest change of the
     * weights of a cell with which affine functions, rotations among them, are exact there.
     */
    template <int dim>
    void make_affine(const Cell<dim> &cell, const Point<dim> &position, Weights<dim> &weights)
    {
      const double   size    = cell->diameter();
      Tensor<1, dim> missing = position;
      for (unsigned int v = 0; v < weights.size(); ++v)
        missing -= weights[v] * cell->vertex(v);
      if (missing.norm() < negligible * size)
        return;
      Eigen::Matrix<double, dim + 1, GeometryInfo<dim>::vertices_per_cell> moments;
      Eigen::Matrix<double, dim + 1, 1>                                    change;
      change[0] = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        change[1 + d] = missing[d] / size;
      for (unsigned int v = 0; v < weights.size(); ++v)
        {
          moments(0, v) = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            moments(1 + d, v) = (cell->vertex(v)[d] - position[d]) / size;
        }
      const auto corrections =
        (moments.transpose() * (moments * moments.transpose()).ldlt().solve(change)).eval();
      for (unsigned int v = 0; v < weights.size(); ++v)
        weights[v] += corrections[v];
    }


    template <int dim>
    class Ancestry
    {
    public:
      explicit Ancestry(const Discretization<dim> &discretization)
        : discretization(discretization)
        , first_owned(discretization.locally_owned().is_empty()
                        ? 0
                        : discretization.locally_owned().nth_index_in_set(0) / dim)
        , origins(discretization.locally_owned().n_elements() / dim)
      {
      }

      std::vector<NodeOrigin> find()
      {
        std::vector<char> known(origins.size(), 0);
        for (const auto &cell : discretization.cells())
          if (cell->is_locally_owned())
            for (const unsigned int v : cell->vertex_indices())
              {
                const auto node = cell->vertex_dof_index(v, 0) / dim;
                if (node < first_owned || node >= first_owned + origins.size())
                  continue;
                if (known[node - first_owned])
                  continue;
                known[node - first_owned] = 1;
                if (!discretization.hanging_node_constraints().is_constrained(dim * node))
                  find_origin(node - first_owned, cell, v);
              }
        ask_others();
        for (NodeOrigin &origin : origins)
          unite(origin.parents);
        return std::move(origins);
      }

    private:
      struct Question
      {
        unsigned int node; ///< whose parent it is
        double       weight;
        VertexName   name;
      };

      const Discretization<dim>    &discretization;
      const types::global_dof_index first_owned;
      std::vector<NodeOrigin>       origins;
      std::vector<Question>         questions;

      /** Go up from a cell as long as the vertex is one of the parent, too. */
      void find_origin(const unsigned int node, Cell<dim> cell, unsigned int vertex)
      {
        while (cell->level() > 0)
          {
            const unsigned int child = number_of_child<dim>(cell);
            if (child != vertex)
              {
                // Where both numbers agree in a bit the vertex is at an end of the parent.
                set_parents(node, cell, child, vertex);
                return;
              }
            cell = cell->parent();
          }
      }

      void set_parents(const unsigned int node,
                       const Cell<dim>   &cell,
                       const unsigned int child,
                       const unsigned int vertex)
      {
        origins[node].level        = cell->level();
        const unsigned int between = child ^ vertex; // bits of the directions that are halved
        Weights<dim>       weights{};
        unsigned int       n_vertices = 0;
        for (unsigned int v = 0; v < weights.size(); ++v)
          if ((v & ~between) == (vertex & ~between))
            {
              weights[v] = 1.;
              ++n_vertices;
            }
        for (double &weight : weights)
          weight /= n_vertices;
        make_affine<dim>(cell->parent(), cell->vertex(vertex), weights);
        for (unsigned int v = 0; v < weights.size(); ++v)
          if (weights[v] != 0.)
            add_parent(node, cell->parent(), v, weights[v]);
      }

      void add_parent(const unsigned int node,
                      const Cell<dim>   &cell,
                      const unsigned int vertex,
                      const double       weight)
      {
        Cell<dim> leaf = cell;
        while (leaf->has_children())
          leaf = leaf->child(vertex);
        if (leaf->is_artificial())
          questions.push_back({node, weight, {cell->id().template to_binary<dim>(), vertex}});
        else
          add(resolved(leaf->vertex_dof_index(vertex, 0) / dim), weight, origins[node].parents);
      }

      /** A node of a cell of this process or at its border, or what it hangs between. */
      std::vector<WeightedNode> resolved(const types::global_dof_index node) const
      {
        const auto *line =
          discretization.hanging_node_constraints().get_constraint_entries(dim * node);
        if (line == nullptr)
          return {{node, 1.}};
        std::vector<WeightedNode> result;
        for (const auto &[dof, weight] : *line)
          result.emplace_back(dof / dim, weight);
        return result;
      }

      static void add(const std::vector<WeightedNode> &nodes,
                      const double                     weight,
                      std::vector<WeightedNode>       &sum)
      {
        for (const auto &[node, part] : nodes)
          sum.emplace_back(node, weight * part);
      }

      /** The same node may come from several vertices that hang. */
      static void unite(std::vector<WeightedNode> &nodes)
      {
        std::sort(nodes.begin(), nodes.end());
        std::size_t n = 0;
        for (std::size_t k = 0; k < nodes.size(); ++k)
          if (n > 0 && nodes[n - 1].first == nodes[k].first)
            nodes[n - 1].second += nodes[k].second;
          else
            nodes[n++] = nodes[k];
        nodes.resize(n);
      }

      using Published = std::unordered_map<VertexName, std::vector<WeightedNode>, VertexNameHash>;

      /** Vertices of refined cells that other processes own cells in, too. */
      Published vertices_of_cut_cells() const
      {
        std::set<std::pair<int, int>> cut; // level and index of cells with cells of others
        for (const auto &leaf : discretization.cells())
          if (!leaf->is_locally_owned())
            for (Cell<dim> cell = leaf; cell->level() > 0;)
              {
                cell = cell->parent();
                if (!cut.insert({cell->level(), cell->index()}).second)
                  break;
              }
        Published result;
        for (const auto &leaf : discretization.cells())
          if (leaf->is_locally_owned() && leaf->level() > 0)
            {
              const unsigned int vertex = number_of_child<dim>(leaf);
              const auto         parts  = resolved(leaf->vertex_dof_index(vertex, 0) / dim);
              for (Cell<dim> cell = leaf;
                   cell->level() > 0 && number_of_child<dim>(cell) == vertex;)
                {
                  cell = cell->parent();
                  if (cut.count({cell->level(), cell->index()}) > 0)
                    result[{cell->id().template to_binary<dim>(), vertex}] = parts;
                }
            }
        return result;
      }

      /** By way of a process that follows from the name of the vertex. */
      void ask_others()
      {
        const MPI_Comm     communicator = discretization.communicator();
        const unsigned int n_processes  = Utilities::MPI::n_mpi_processes(communicator);
        if (n_processes == 1)
          return;
        const auto keeper = [&](const VertexName &name) {
          return static_cast<unsigned int>(VertexNameHash()(name) % n_processes);
        };
        using Answer = std::vector<WeightedNode>;
        std::map<unsigned int, std::vector<std::pair<VertexName, Answer>>> to_publish;
        for (const auto &entry : vertices_of_cut_cells())
          to_publish[keeper(entry.first)].push_back(entry);
        Published kept;
        for (const auto &[rank, entries] : Utilities::MPI::some_to_some(communicator, to_publish))
          kept.insert(entries.begin(), entries.end());

        std::map<unsigned int, std::vector<VertexName>> to_ask;
        std::map<unsigned int, std::vector<Question>>   asked;
        for (const Question &question : questions)
          {
            to_ask[keeper(question.name)].push_back(question.name);
            asked[keeper(question.name)].push_back(question);
          }
        std::map<unsigned int, std::vector<Answer>> answers;
        for (const auto &[rank, names] : Utilities::MPI::some_to_some(communicator, to_ask))
          for (const VertexName &name : names)
            answers[rank].push_back(kept.at(name));
        for (const auto &[rank, received] : Utilities::MPI::some_to_some(communicator, answers))
          for (std::size_t k = 0; k < received.size(); ++k)
            {
              const Question &question = asked[rank][k];
              add(received[k], question.weight, origins[question.node].parents);
            }
      }
    };
  } // namespace


  template <int dim>
  std::vector<NodeOrigin> node_origins(const Discretization<dim> &discretization)
  {
    return Ancestry<dim>(discretization).find();
  }


  template std::vector<NodeOrigin> node_origins(const Discretization<2> &);
  template std::vector<NodeOrigin> node_origins(const Discretization<3> &);
} // namespace signorini
