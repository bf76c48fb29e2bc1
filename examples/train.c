// SPDX-License-Identifier: MIT
// train.c -- trains a cart to balance a pole, in a batch of 256 worlds and without any other library: train [DEVICE]
//
// A policy has four weights: the force on the cart is the sum of weights times state. In each generation every world tries
// the middle weights plus random numbers; the mean of those that balance longer than the average is the next middle. In the
// last generation all worlds try the middle. The hash of all worlds is the same on every device.
#include <inttypes.h>
#include <math.h>
#include <scree/scree_math.h>
#include <stdio.h>
#include <stdlib.h>

#define WORLDS      256
#define STEPS       600 // 10 s
#define GENERATIONS 10

// Scree calls this function if a call fails, so the program checks no result.
static void stop(const char* function, scree_status status, const char* sentence, void* context)
{
	(void)function, (void)status, (void)context;
	fprintf(stderr, "%s\n", sentence);
	exit(1);
}

int main(int count, char** arguments)
{
	static float weights[WORLDS][4], state[WORLDS][4], force[WORLDS][2], push[WORLDS];
	static uint64_t hashes[WORLDS], sum;
	float middle[4] = {0.0f};
	scree_fail_hook_set(stop, NULL);

	// the template, an ordinary world: a cart on a rail, which is a joint to the world, and a pole of 1 m on a hinge
	scree_world_def world_def = scree_world_def_default();
	world_def.sleep = false; // no pole falls asleep while it stands
	scree_world* world;
	scree_body cart, pole;
	scree_joint joints[2];
	scree_joint_def defs[] = {scree_joint_def_make(SCREE_JOINT_PRISMATIC), scree_joint_def_make(SCREE_JOINT_REVOLUTE)};
	const scree_pose origin = scree_pose_make(0.0f, 0.0f, 0.0f);
	const scree_vec foot = {0.0f, 0.0f}, tip = {0.0f, 1.0f};
	scree_world_create(&world_def, &world);
	scree_body_create_box(world, SCREE_BODY_DYNAMIC, origin, 0.25f, 0.1f, 0, &cart);
	scree_body_create_capsule(world, SCREE_BODY_DYNAMIC, origin, foot, tip, 0.04f, 0, &pole);
	defs[0].body_b = defs[1].body_a = cart;
	defs[1].body_b = pole;
	scree_joints_create(world, defs, 2, joints);

	// the batch: 256 copies of the template
	scree_batch_def def = scree_batch_def_default();
	scree_batch* batch;
	def.worlds = WORLDS;
	def.templates = &world;
	def.template_count = 1;
	def.device = count > 1 ? arguments[1] : "cpu";
	scree_batch_create(&def, &batch);

	// inputs: a force on the cart in each step, and a push of the pole at each start; state: place and speed of the cart, m and
	// m/s, angle and speed of the pole, rad and rad/s
	scree_channel forces = scree_channel_make(SCREE_INPUT_FORCE), states[4];
	scree_channel starts = scree_channel_make(SCREE_INPUT_ANGULAR_IMPULSE);
	forces.body = cart;
	starts.body = pole;
	for (int i = 0; i < 4; ++i)
	{
		states[i] = scree_channel_make(i % 2 ? SCREE_OUTPUT_JOINT_SPEED : SCREE_OUTPUT_JOINT_VALUE);
		states[i].joint = joints[i / 2];
		states[i].which = i < 2 ? SCREE_ALONG : SCREE_ANGLE;
	}
	scree_batch_bind(batch, SCREE_STEP_INPUTS, &forces, 1, force[0]);
	scree_batch_bind(batch, SCREE_RESET_INPUTS, &starts, 1, push);
	scree_batch_bind(batch, SCREE_OUTPUTS, states, 4, state[0]);

	for (uint32_t generation = 0; generation < GENERATIONS; ++generation)
	{
		const float spread = generation + 1 < GENERATIONS ? 4.0f : 0.0f;
		float sums[4] = {0.0f};
		uint8_t fallen[WORLDS] = {0};
		int score[WORLDS] = {0}, total = 0, good = 0;
		for (int k = 0; k < WORLDS; ++k)
		{
			const scree_random a = scree_random_make(1, (uint64_t)k, generation, 0);
			const scree_random b = scree_random_make(1, (uint64_t)k, generation, 1);
			for (int i = 0; i < 4; ++i)
				weights[k][i] = middle[i] + scree_random_between(a.words[i], -spread, spread);
			push[k] = scree_random_between(b.words[0], -0.03f, 0.03f); // N m s
		}
		scree_batch_reset(batch, NULL);
		scree_batch_observe(batch);
		for (int step = 0; step < STEPS; ++step)
		{
			for (int k = 0; k < WORLDS; ++k)
			{
				const float *w = weights[k], *s = state[k];
				force[k][0] = w[0] * s[0] + w[1] * s[1] + w[2] * s[2] + w[3] * s[3];
				fallen[k] |= fabsf(s[0]) > 2.4f || fabsf(s[2]) > 0.5f;
				score[k] += !fallen[k];
				total += !fallen[k];
			}
			scree_batch_pause(batch, fallen); // worlds that have lost take no time
			scree_batch_step(batch, 1.0f / 60.0f, 4, 1);
		}
		for (int k = 0; k < WORLDS; ++k)
			if (score[k] * WORLDS >= total && ++good)
				for (int i = 0; i < 4; ++i)
					sums[i] += weights[k][i];
		for (int i = 0; i < 4; ++i)
			middle[i] = sums[i] / (float)good;
		printf("generation %2" PRIu32 ": poles stand for %5.2f s of 10 s\n", generation, (double)total / WORLDS / 60.0);
	}
	scree_batch_get_hashes(batch, hashes);
	for (int k = 0; k < WORLDS; ++k)
		sum += hashes[k];
	printf("sum of the hashes %016" PRIx64 "\n", sum);
	scree_batch_destroy(batch);
	scree_world_destroy(world);
	return 0;
}
