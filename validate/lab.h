// SPDX-License-Identifier: MIT
// lab.h -- declares the lab of an experiment: a world in an engine, and copies of its bodies and joints.
#ifndef LAB_H
#define LAB_H
#include "validation.h"

LabDef lab_def(void); // returns the defaults: gravity (0, -10), 60 Hz x 4 substeps, maximum speed 400 m/s

// Opens a lab; never returns null. The caller closes the lab before it opens another.
Lab* lab_open(Validation* validation, const LabDef* def);
void lab_close(Lab* lab);

// These functions add a body and return its index. The engine creates the body before the next step.
int lab_add(Lab* lab, const scree_body_def* def, const EnginePart* parts, int count);
int lab_put(Lab* lab, scree_body_type type, const scree_attribute_def* surface, float x, float y, float angle);
int lab_throw(Lab* lab, const scree_attribute_def* surface, float x, float y, float angle, scree_velocity velocity);

// Adds a joint between bodies a and b. The engine creates the joint before the next step.
void lab_join(Lab* lab, const scree_joint_def* def, int a, int b);

void lab_step(Lab* lab, int steps);
// takes one step and returns whether it succeeded; on failure it prints a message, but the validation goes on
bool lab_try(Lab* lab);
void lab_read(Lab* lab);
void lab_wait(Lab* lab);
void lab_set_velocity(Lab* lab, int body, scree_velocity velocity);
void lab_push(Lab* lab, int body, scree_vec force);
void lab_teleport(Lab* lab, const int* bodies, const scree_pose* poses, int count);
void lab_replace(Lab* lab, const int* bodies, const scree_pose* poses, int count);
double lab_bytes(Lab* lab);
uint64_t lab_hash(Lab* lab);

// These functions use the state that the last call of lab_read has read.
double lab_kinetic(const Lab* lab, int body); // J; 0 unless the body is dynamic
double lab_speed(const Lab* lab, int body);   // m/s
scree_vec lab_center(const Lab* lab, int body);
// Returns the speed of the fastest dynamic body, m/s. Writes the index of this body to *body, unless `body` is null.
double lab_fastest(const Lab* lab, int* body);

// Returns a hash of the end states of all labs of the case; an open lab contributes its present state.
uint64_t lab_case_hash(Validation* validation);

// Returns the larger of two numbers, or NaN if one of them is NaN. fmax would drop the NaN, and the check of a maximum
// would pass.
static inline double larger(double a, double b) { return a >= b || a != a ? a : b; }

#endif
