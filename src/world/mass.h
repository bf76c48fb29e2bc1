// SPDX-License-Identifier: MIT
// mass.h -- the mass of a body, from its collidables.
#ifndef MASS_H
#define MASS_H
#include "world/world.h"

// What the user set, or the sum over the collidables. A dynamic body without any has 1 kg and cannot turn; other types have mass 0.
scree_mass mass_of_body(const scree_world* world, int body);

// Inverse mass, 1/kg, and inverse inertia, 1/(kg m^2). An inverse of 0 is 0, and so is the inertia's when rotation is locked.
float mass_inverse(const HostBody* host);
float mass_inverse_inertia(const HostBody* host);

// The row of a body in the pool guarded, and the command that writes it. May lower Pipeline.guard_way and raise guard_reach.
Guarded body_guarded(scree_world* world, int body);
Command guarded_command(scree_world* world, int body);

// Sets the mass of a body on the host and on the device. The caller has reserved room for two commands.
void mass_set(scree_world* world, int body, scree_mass mass);

// The same for a mass that the user set: it stays while the body is of another type, until its collidables change.
void mass_own(scree_world* world, int body, scree_mass mass);

// Recomputes the mass of each dynamic body among these, once per body; -1 stands for no body.
void masses_update(scree_world* world, const int* bodies, int count);

#endif
