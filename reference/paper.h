// SPDX-License-Identifier: MIT
// paper.h -- the pipeline of the paper that Scree grew from, kept as a reference, and the oracle of the broad phase.
//
// Falco Girgis and Earl Wells, GPGPU Acceleration for Video Game Physics Engines: integrate, transform, detect, resolve.
// The first three run on a device, to which the pools are copied in every step and from which they come back; contacts
// are resolved on the host, the most severe first. Rolling resistance and tangent speed are not in the paper and mean
// nothing here.
#ifndef PAPER_H
#define PAPER_H
#include "scree/scree.h"

typedef struct Paper Paper;

typedef struct
{
	int bodies, collidables;
	int contacts;      // overlapping pairs found by the last step
	float penetration; // deepest overlap of two bodies among them, m
	int64_t steps;
} PaperCounters;

typedef struct // milliseconds of the last step
{
	double step;                   // wall clock
	double to_device, from_device; // copying the pools; zero on the CPU
	double integrate, transform, detect, resolve;
} PaperTimings;

// Copies bodies, collidables and gravity out of a world, which goes on independently and may be destroyed. device is
// "cpu", "opencl" or "opencl:NAME", as in scree_world_def.
scree_status paper_create(scree_world* world, const char* device, bool allow_unequal_bits, Paper** paper);
void paper_destroy(Paper* paper); // null is allowed

// Advances by dt seconds (0 < dt <= 1).
scree_status paper_step(Paper* paper, float dt);

// Adds to the accumulators of a body, named by its place in scree_world_get_bodies: N, N m, for the next step.
scree_status paper_apply(Paper* paper, int body, scree_vec force, float torque);

// Write the first count bodies in the order that scree_world_get_bodies had.
scree_status paper_poses(const Paper* paper, scree_pose* poses, int count);
scree_status paper_velocities(const Paper* paper, scree_velocity* velocities, int count);

PaperCounters paper_counters(const Paper* paper);
PaperTimings paper_timings(const Paper* paper);
const char* paper_device(const Paper* paper); // "cpu", "opencl:NVIDIA H200"; owned by paper
uint64_t paper_hash(const Paper* paper);      // of the bodies and the last step's contacts

typedef struct
{
	int a, b; // a < b
} PaperPair;

// Tests every box against every other, the edges included. Writes up to capacity overlapping pairs, by rising a, then b,
// and how many there are.
scree_status paper_pairs(const scree_box* boxes, int box_count, PaperPair* pairs, int capacity, int* count);

#endif
