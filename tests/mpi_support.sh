# SPDX-License-Identifier: MIT
# mpi_support.sh -- is sourced by tests that start programs of MPI, by "$mpiexec".
mpiexec=${SCREE_MPIEXEC:-mpiexec}

# Open MPI refuses to run as root, and to start more ranks than there are cores; idle ranks would take the cores of busy ones
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_mpi_yield_when_idle=1
# containers forbid that processes read each other's memory, and have no network but the loopback
export OMPI_MCA_btl_vader_single_copy_mechanism=none OMPI_MCA_btl=self,vader
# without /sys, as in a folder with a bare system, Open MPI finds no processors and aborts
[ -e /sys/devices/system/cpu ] || HWLOC_SYNTHETIC="core:$(nproc) pu:1"
[ -z "${HWLOC_SYNTHETIC:-}" ] || export HWLOC_SYNTHETIC
