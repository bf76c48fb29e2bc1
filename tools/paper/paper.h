// SPDX-License-Identifier: MIT
// paper.h -- declares the pipeline of the paper that Scree started from, which is kept as a reference.
//
// Falco Girgis and Earl Wells, GPGPU Acceleration for Video Game Physics Engines. The stages are integrate, transform,
// detect and resolve. The first three run on a device; in every step the pools are copied to the device and back. The
// host resolves the contacts, the most severe first. Rolling resistance and tangent speed are ignored, because the
// paper does not have them.
#ifndef PAPER_H
#define PAPER_H
#include "scree/scree.h"
#include "tools/paper/paper_counters.h"

typedef struct Paper Paper;

// Copies bodies, collidables and gravity of a world. The world may be destroyed afterwards. device: "cpu", "opencl" or
// "opencl:NAME", as in scree_world_def.
scree_status paper_create(scree_world* world, const char* device, bool allow_unequal_bits, Paper** paper);
void paper_destroy(Paper* paper); // null is allowed

// Takes a step of dt seconds (0 < dt <= 1).
scree_status paper_step(Paper* paper, float dt);

// Adds a force (N) and a torque (N m) for the next step. body: index in the list of scree_world_get_bodies.
scree_status paper_apply(Paper* paper, int body, scree_vec force, float torque);

// These write the poses or velocities of the first `count` bodies, in the order of scree_world_get_bodies.
scree_status paper_poses(const Paper* paper, scree_pose* poses, int count);
scree_status paper_velocities(const Paper* paper, scree_velocity* velocities, int count);

PaperCounters paper_counters(const Paper* paper);
PaperTimings paper_timings(const Paper* paper);
const char* paper_device(const Paper* paper); // e.g. "cpu" or "opencl:NVIDIA H200"; owned by paper
uint64_t paper_hash(const Paper* paper);      // hash of the bodies and of the contacts of the last step

#endif
