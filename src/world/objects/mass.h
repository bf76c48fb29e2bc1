// SPDX-License-Identifier: MIT
// mass.h -- computes the mass of a body from its collidables.
#ifndef MASS_H
#define MASS_H
#include "world/world.h"

// Returns the mass that the user set, else the sum over collidables, else 1 kg without inertia; 0 if not dynamic.
scree_mass mass_of_body(const scree_world* world, int body);

// Returns HostBody.mass with the correct inertia, even if the inertia is still pending.
scree_mass mass_now(const scree_world* world, int body);

// Return the inverse mass, 1/kg, and inverse inertia, 1/(kg m^2): 0 for the inverse of 0 and for a locked rotation.
float mass_inverse(const HostBody* host);
float mass_inverse_inertia(const HostBody* host);

// Return the row of a body in the pool continuous_body, and the command that sets it. Both may lower
// Pipeline.continuous_way, and raise Pipeline.continuous_reach.
ContinuousBody continuous_row(scree_world* world, int body);
Command continuous_command(scree_world* world, int body);

// Records an anchor of a joint in the body's frame, which may raise the inertia. Needs reserved memory for one command.
void mass_anchor(scree_world* world, int body, scree_vec anchor);

// Updates the inverse inertia of a body whose mass the user set, after a collidable became a sensor or solid. body: -1
// for none. Needs reserved memory for one command.
void mass_touches(scree_world* world, int body);

// Sets the mass of a body on the host and on the device. Needs reserved memory for two commands.
void mass_set(scree_world* world, int body, scree_mass mass);

// Sets a mass that the user gave. It is kept, even while the body is not dynamic, until the body gets or loses a
// collidable. Needs reserved memory for two commands.
void mass_own(scree_world* world, int body, scree_mass mass);

// Recomputes the mass of each dynamic body in a list, and discards a mass that the user set. A body may be listed
// several times, and an entry of -1 is no body. For all other bodies, only records the ContinuousBody. gained: the
// bodies only got collidables, so the next mass_settle computes the inertia; edits_reserve has left memory for its
// command. If each call computed the inertia, n collidables created one by one would need sums of n^2 / 2 terms.
void masses_update(scree_world* world, const int* bodies, int count, bool gained);

// Computes the pending inertia. Called before uploads, and before reads and commands that depend on the inertia.
void mass_settle(scree_world* world);

// Discards the sums of a body whose mass is set in another way, or which is about to be destroyed.
void mass_forget(scree_world* world, int body);

#endif
