// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// The program, started once for many runs: its libraries need a third of a second to load and to
// initialise, its work on a small scene a few milliseconds. Each run is a child that starts where
// the libraries are ready, and cannot disturb the next one.
//
// fuzz_server SECONDS BYTES: the limits of a run, processor time and memory (0: none). Each line of
// the input names a folder, with the arguments of the run in the file `arguments` (a zero byte
// after each). The output of the run goes to the files `out` and `err` there, and the answer is a
// line with the status as the shell would give it: 128 and more after a signal.

#include <signorini/program/run_program.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace
{
  /** A run that waits for something gets this many times its processor time by the clock. */
  constexpr unsigned int patience = 20;

  struct Limits
  {
    rlim_t seconds;
    rlim_t bytes;
  };

  std::vector<std::string> read_arguments(const std::string &file)
  {
    std::ifstream            in(file, std::ios::binary);
    std::vector<std::string> arguments;
    for (std::string argument; std::getline(in, argument, '\0');)
      arguments.push_back(argument);
    return arguments;
  }

  void redirect(const int descriptor, const std::string &file)
  {
    const int target = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (target < 0 || dup2(target, descriptor) < 0)
      _exit(EXIT_FAILURE);
    close(target);
  }

  /** The signal of the soft limit tells what was exceeded; the hard limit kills. */
  void restrict(const int resource, const rlim_t limit)
  {
    const rlimit limits = {limit, limit + 1};
    if (limit > 0 && setrlimit(resource, &limits) != 0)
      _exit(EXIT_FAILURE);
  }

  /** What the child does. MPI and the libraries belong to the parent, and end with it. */
  [[noreturn]] void run(const std::string &folder, const Limits &limits)
  {
    redirect(STDOUT_FILENO, folder + "/out");
    redirect(STDERR_FILENO, folder + "/err");
    restrict(RLIMIT_CPU, limits.seconds);
    restrict(RLIMIT_AS, limits.bytes);
    alarm(patience * limits.seconds);
    const int status =
      signorini::run_program(read_arguments(folder + "/arguments"), MPI_COMM_WORLD);
    std::cout.flush();
    _exit(status);
  }

  /** @return the status as the shell would give it */
  int wait_for(const pid_t child)
  {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }
} // namespace

int main(int argc, char **argv)
{
  if (argc != 3)
    {
      std::cerr << "usage: fuzz_server SECONDS BYTES\n";
      return 2;
    }
  const Limits                             limits = {std::stoul(argv[1]), std::stoul(argv[2])};
  int                                      only_the_name = 1;
  dealii::Utilities::MPI::MPI_InitFinalize mpi(only_the_name, argv, 1);
  for (std::string folder; std::getline(std::cin, folder);)
    {
      const pid_t child = fork();
      if (child == 0)
        run(folder, limits);
      std::cout << wait_for(child) << std::endl;
    }
  return 0;
}
