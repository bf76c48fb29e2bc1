// SPDX-License-Identifier: MIT
// paper.h -- the pipeline of the paper that Scree started from, kept as a reference.
//
// Falco Girgis and Earl Wells, GPGPU Acceleration for Video Game Physics Engines: integrate, transform, detect, resolve.
// The first three run on a device, to which the pools are copied in every step and from which they come back; contacts
// are resolved on the host, the most severe first. The paper has no rolling resistance and no tangent speed; they are
// ignored here.
#ifndef PAPER_H
#define PAPER_H
#include "scree/scree.h"
#include "tools/paper/paper_counters.h"

typedef struct Paper Paper;

// Copies bodies, collidables and gravity of a world, which may be destroyed afterwards. device is "cpu", "opencl" or
// "opencl:NAME", as in scree_world_def.
scree_status paper_create(scree_world* world, const char* device, bool allow_unequal_bits, Paper** paper);
void paper_destroy(Paper* paper); // null is allowed

// Advances by dt seconds (0 < dt <= 1).
scree_status paper_step(Paper* paper, float dt);

// Adds a force (N) and a torque (N m) for the next step; body: its index in scree_world_get_bodies.
scree_status paper_apply(Paper* paper, int body, scree_vec force, float torque);

// Write the first count bodies in the order of scree_world_get_bodies.
scree_status paper_poses(const Paper* paper, scree_pose* poses, int count);
scree_status paper_velocities(const Paper* paper, scree_velocity* velocities, int count);

PaperCounters paper_counters(const Paper* paper);
PaperTimings paper_timings(const Paper* paper);
const char* paper_device(const Paper* paper); // "cpu", "opencl:NVIDIA H200"; owned by paper
uint64_t paper_hash(const Paper* paper);      // covers the bodies and the last step's contacts

#endif
