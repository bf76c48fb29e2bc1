// SPDX-License-Identifier: MIT
// lab.h -- the world of an experiment.
#ifndef LAB_H
#define LAB_H
#include "validation.h"

LabDef lab_def(void); // gravity (0, -10), 60 Hz x 4 substeps, 400 m/s

// Never returns null. The caller closes the lab before it opens another.
Lab* lab_open(Validation* validation, const LabDef* def);
void lab_close(Lab* lab);

// Adds a body and returns its index. The engine creates it before the next step.
int lab_add(Lab* lab, const scree_body_def* def, const EnginePart* parts, int count);
int lab_put(Lab* lab, scree_body_type type, const scree_attribute_def* surface, float x, float y, float angle);
int lab_throw(Lab* lab, const scree_attribute_def* surface, float x, float y, float angle, scree_velocity velocity);

// Adds a joint between two bodies, which the engine creates before the next step.
void lab_join(Lab* lab, const scree_joint_def* def, int a, int b);

void lab_step(Lab* lab, int steps);
bool lab_try(Lab* lab); // takes one step; a failure is printed but does not end the validation
void lab_read(Lab* lab);
void lab_wait(Lab* lab);
void lab_set_velocity(Lab* lab, int body, scree_velocity velocity);
void lab_push(Lab* lab, int body, scree_vec force);
void lab_teleport(Lab* lab, const int* bodies, const scree_pose* poses, int count);
void lab_replace(Lab* lab, const int* bodies, const scree_pose* poses, int count);
double lab_bytes(Lab* lab);
uint64_t lab_hash(Lab* lab);

// These use the last state that lab_read has read.
double lab_kinetic(const Lab* lab, int body); // J, 0 unless dynamic
double lab_speed(const Lab* lab, int body);   // m/s
scree_vec lab_center(const Lab* lab, int body);
double lab_fastest(const Lab* lab, int* body); // m/s, of dynamic bodies; body may be null

// A hash of the end states of all labs of the case, with the present state of the open lab.
uint64_t lab_case_hash(Validation* validation);

#endif
