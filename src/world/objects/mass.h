// SPDX-License-Identifier: MIT
// mass.h -- the mass of a body, from its collidables.
#ifndef MASS_H
#define MASS_H
#include "world/world.h"

// What the user set, or the sum over the collidables. A dynamic body without any has 1 kg and cannot turn; other types have mass 0.
scree_mass mass_of_body(const scree_world* world, int body);

// HostBody.mass with its inertia, which may not be there yet.
scree_mass mass_now(const scree_world* world, int body);

// Inverse mass, 1/kg, and inverse inertia, 1/(kg m^2). An inverse of 0 is 0, and so is the inertia's when rotation is locked.
float mass_inverse(const HostBody* host);
float mass_inverse_inertia(const HostBody* host);

// The row of a body in the pool guarded, and the command that writes it. May lower Pipeline.continuous_way and raise continuous_reach.
ContinuousBody continuous_row(scree_world* world, int body);
Command continuous_command(scree_world* world, int body);

// Notes an anchor of a joint, in the body's frame. The caller has reserved room for a command.
void mass_anchor(scree_world* world, int body, scree_vec anchor);

// Notes that a collidable of a body became a sensor, or solid; -1 for no body. The caller has reserved room for a command.
void mass_touches(scree_world* world, int body);

// Sets the mass of a body on the host and on the device. The caller has reserved room for two commands.
void mass_set(scree_world* world, int body, scree_mass mass);

// The same for a mass that the user set: it stays while the body is of another type, until its collidables change.
void mass_own(scree_world* world, int body, scree_mass mass);

// Recomputes the mass of each dynamic body among these, once per body, and sends what guard knows of the others; -1 stands for no
// body. gained: they only got more collidables. Then the inertia is computed by the next mass_settle, which takes room for a command
// that edits_reserve always leaves: a body of many collidables is made one by one, and the sum over all of them for each would take a time that grows with the square of their number.
void masses_update(scree_world* world, const int* bodies, int count, bool gained);

// Computes the inertia that is not yet: before an upload, and before anything that reads it or a command that depends on it.
void mass_settle(scree_world* world);

// Drops what is known of a body: another mass holds, or the body is about to be destroyed.
void mass_forget(scree_world* world, int body);

#endif
