# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
# Copyright (C) 2026 by the signorini authors
#
# The Debian package in an image, without what built it:
#
#   docker build -t signorini .
#   docker run --rm -v "$PWD:/work" signorini scene.prm
#   docker run --rm -v "$PWD:/work" --entrypoint mpirun signorini -np 4 signorini scene.prm

FROM debian:12 AS build
COPY . /source
RUN apt-get update && cd /source && ./dev package

FROM debian:12
COPY --from=build /source/build/package/*.deb /tmp/
RUN apt-get update && apt-get install -y --no-install-recommends /tmp/*.deb \
  && rm -rf /tmp/*.deb /var/lib/apt/lists/*
# In a container all are root, and OpenMPI wants to be told.
ENV OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMP_NUM_THREADS=1
WORKDIR /work
ENTRYPOINT ["signorini"]
