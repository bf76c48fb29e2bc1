// SPDX-License-Identifier: MIT
// ragdoll.c -- adds a ragdoll of 11 bodies to a scene made by code.
#include "ragdoll.h"
#include "validate/bones.h"

void ragdoll_add(FixtureBuild* build, scree_vec at, int group, uint64_t user)
{
	scree_body bodies[BONES];
	for (int k = 0; k < BONES; ++k)
	{
		EnginePart parts[BONE_PARTS];
		scree_body_def def = bone_def(k, at, group);
		int count = bone_parts(k, group, parts), parent = bone_parent(k);
		def.user = user;
		bodies[k] = fixture_put(build, def, &parts[0].surface);
		for (int part = 1; part < count; ++part)
			fixture_attach(build, bodies[k], &parts[part].surface, (scree_vec){0.0f, 0.0f}, parts[part].filter);
		if (parent < 0)
			continue;
		scree_joint_def joint = bone_joint(k);
		joint.body_a = bodies[parent];
		joint.body_b = bodies[k];
		fixture_join(build, &joint);
	}
}
