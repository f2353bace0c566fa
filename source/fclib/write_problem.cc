// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/fclib/write_problem.h>
#include <signorini/output/whole_file.h>

#include <hdf5.h>

#include <sstream>
#include <vector>

namespace signorini
{
  namespace
  {
    /** An object of HDF5, and what closes it. */
    class Handle
    {
    public:
      Handle(const hid_t id, herr_t (*close)(hid_t))
        : id(id)
        , close(close)
      {
        if (id < 0)
          throw RunError("HDF5 cannot make the problem of a step.");
      }
      ~Handle() { close(id); }
      Handle(const Handle &)            = delete;
      Handle &operator=(const Handle &) = delete;

      operator hid_t() const { return id; }

    private:
      const hid_t id;
      herr_t (*const close)(hid_t);
    };


    void check(const herr_t status)
    {
      if (status < 0)
        throw RunError("HDF5 cannot write the problem of a step.");
    }


    Handle group(const hid_t parent, const std::string &name)
    {
      return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose};
    }


    template <typename Number>
    void write(const hid_t parent, const std::string &name, const Number *values, const hsize_t n)
    {
      const hid_t  type = std::is_same_v<Number, int> ? H5T_NATIVE_INT : H5T_NATIVE_DOUBLE;
      const Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose);
      const Handle data(
        H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Dclose);
      check(H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
    }


    void write(const hid_t parent, const std::string &name, const int value)
    {
      write(parent, name, &value, 1);
    }


    void write(const hid_t parent, const std::string &name, const Eigen::VectorXd &vector)
    {
      write(parent, name, vector.data(), vector.size());
    }


    void write(const hid_t parent, const std::string &name, const std::string &text)
    {
      const Handle type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
      check(H5Tset_size(type, text.size() + 1));
      const Handle data(
        H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Dclose);
      check(H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()));
    }


    /** In compressed columns, which FCLIB tells by the number -1 of triplets. */
    void write(const hid_t parent, const std::string &name, const FrictionalProblem::Matrix &matrix)
    {
      const Handle own = group(parent, name);
      write(own, "nzmax", matrix.nonZeros());
      write(own, "m", matrix.rows());
      write(own, "n", matrix.cols());
      write(own, "nz", -1);
      write(own, "p", matrix.outerIndexPtr(), matrix.cols() + 1);
      write(own, "i", matrix.innerIndexPtr(), matrix.nonZeros());
      write(own, "x", matrix.valuePtr(), matrix.nonZeros());
    }


    void write_info(const hid_t parent, const FrictionalProblem &problem)
    {
      std::ostringstream title, description;
      title << "signorini: step " << problem.step;
      description << "signorini, step " << problem.step << " from time " << problem.start_time
                  << " by " << problem.step_size << "; velocities are means of the step; r times "
                  << problem.force_per_reaction << " are contact forces of nodes";
      const Handle info = group(parent, "info");
      write(info, "title", title.str());
      write(info, "description", description.str());
      write(info, "math_info", std::string("M is symmetric and positive definite."));
    }


    void write_global_form(const hid_t file, const FrictionalProblem &problem)
    {
      const Handle global = group(file, "fclib_global");
      write(global, "spacedim", static_cast<int>(problem.dim));
      write(global, "M", problem.M);
      write(global, "H", problem.H);
      const Handle vectors = group(global, "vectors");
      write(vectors, "f", problem.f);
      write(vectors, "w", problem.w);
      write(vectors, "mu", problem.mu);
      write_info(global, problem);
    }


    void write_local_form(const hid_t file, const FrictionalProblem &problem)
    {
      const LocalForm form  = local_form(problem);
      const Handle    local = group(file, "fclib_local");
      write(local, "spacedim", static_cast<int>(problem.dim));
      write(local, "W", form.W);
      const Handle vectors = group(local, "vectors");
      write(vectors, "q", form.q);
      write(vectors, "mu", problem.mu);
      write_info(local, problem);
    }


    template <typename Number>
    void write_attribute(const hid_t object, const std::string &name, const Number value)
    {
      const hid_t  type = std::is_same_v<Number, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_UINT;
      const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
      const Handle attribute(
        H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
      check(H5Awrite(attribute, type, &value));
    }


    void fill(const hid_t file, const FrictionalProblem &problem)
    {
      write_attribute(file, "step", problem.step);
      write_attribute(file, "start_time", problem.start_time);
      write_attribute(file, "step_size", problem.step_size);
      write_attribute(file, "force_per_reaction", problem.force_per_reaction);
      write_global_form(file, problem);
      if (has_local_form(problem))
        write_local_form(file, problem);
      const Handle solution = group(file, "solution");
      write(solution, "v", problem.v);
      write(solution, "u", problem.u);
      write(solution, "r", problem.r);
    }
  } // namespace


  void write_problem(const std::string &path, const FrictionalProblem &problem)
  {
    // In memory first, so that the file is whole or not there.
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    check(H5Pset_fapl_core(access, std::size_t(1) << 20, false));
    const Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose);
    fill(file, problem);
    check(H5Fflush(file, H5F_SCOPE_GLOBAL));
    std::vector<char> image(H5Fget_file_image(file, nullptr, 0));
    if (H5Fget_file_image(file, image.data(), image.size()) < 0)
      throw RunError("HDF5 cannot write the problem of a step.");
    write_whole_file(path, [&](std::ostream &out) { out.write(image.data(), image.size()); });
  }
} // namespace signorini
