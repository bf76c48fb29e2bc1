// SPDX-License-Identifier: MIT
// evolve.c -- teaches the walker of scenes/walker.json to walk, by evolution of the speeds of its motors in a batch.
//
// A gait has two numbers for each motor, whose speed is a cos + b sin of a common phase. In each generation every world of the batch
// tries the gait in the middle, plus random numbers; the middle of the best gaits is that of the next generation. Random numbers
// depend on the number of the world, so the result is the same on any device, and, compiled with EVOLVE_MPI, on any number of ranks.
// The best gait is then recorded: scree view gait.rec.
//
// This is the evolution strategy of Ingo Rechenberg, Evolutionsstrategie, 1973, with several parents.
#include <scree/scree_math.h>
#include <scree/scree_scene.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#ifdef EVOLVE_MPI
#include <scree/scree_mpi.h>
#endif

#define JOINTS  6
#define WORLDS  256
#define PARENTS 24
#define STEPS   240   // 4 s
#define PERIOD  40    // steps of a stride
#define FALLEN  0.75f // m: height of the hull below which a walker has fallen

typedef struct
{
	float a[JOINTS], b[JOINTS]; // rad/s
} Gait;

static int64_t first;          // global number of the first world of this process
static int worlds = WORLDS;    // number of its worlds
static float distance[WORLDS]; // m: of all walkers, until they fell

// Scree calls this function if a call fails, so the program checks no result.
static void stop(const char* function, scree_status status, const char* sentence, void* context)
{
	(void)function, (void)status, (void)context;
	fprintf(stderr, "%s\n", sentence);
	exit(1);
}

static Gait gait_of(const Gait* middle, float spread, int64_t world, int generation)
{
	Gait gait = *middle;
	for (int k = 0; k < 2 * JOINTS; ++k)
	{
		// the sum of four numbers has nearly a normal distribution
		const scree_random r = scree_random_make(1, (uint64_t)world, (uint32_t)generation, (uint32_t)k);
		float* gene = k < JOINTS ? gait.a + k : gait.b + k - JOINTS;
		for (int i = 0; i < 4; ++i)
			*gene += scree_random_between(r.words[i], -spread, spread);
	}
	return gait;
}

static float speed_of(const Gait* gait, int joint, int step)
{
	const scree_rot phase = scree_rot_make(6.2831853f * (float)(step % PERIOD) / PERIOD);
	return gait->a[joint] * phase.c + gait->b[joint] * phase.s;
}

// All worlds of this process walk. speeds: row of each world for the motors; poses: row of each world with the pose of its hull.
static void walk(scree_batch* batch, const Gait* gaits, float (*speeds)[JOINTS], float (*poses)[4])
{
	uint8_t fallen[WORLDS] = {0};
	memset(distance, 0, sizeof distance);
	scree_batch_reset(batch, NULL);
	for (int step = 0; step < STEPS; ++step)
	{
		for (int k = 0; k < worlds; ++k)
			for (int j = 0; j < JOINTS; ++j)
				speeds[k][j] = speed_of(gaits + k, j, step);
		scree_batch_step(batch, 1.0f / 60.0f, 4, 1);
		for (int k = 0; k < worlds; ++k)
		{
			fallen[k] |= poses[k][1] < FALLEN;
			distance[first + k] = fallen[k] ? distance[first + k] : poses[k][0];
		}
	}
#ifdef EVOLVE_MPI
	// all others have 0 there, so these sums are exact
	MPI_Allreduce(MPI_IN_PLACE, distance, WORLDS, MPI_FLOAT, MPI_SUM, MPI_COMM_WORLD);
#endif
}

// Sorts by distance, then by number, so that the order is the same everywhere.
static int compare(const void* a, const void* b)
{
	const int x = *(const int*)a, y = *(const int*)b;
	return distance[x] != distance[y] ? (distance[x] < distance[y] ? 1 : -1) : x - y;
}

static Gait mean_of(const Gait* middle, float spread, int generation, const int* order)
{
	Gait mean = {{0}, {0}};
	for (int k = 0; k < PARENTS; ++k)
	{
		const Gait parent = gait_of(middle, spread, order[k], generation);
		for (int j = 0; j < JOINTS; ++j)
		{
			mean.a[j] += parent.a[j] / PARENTS;
			mean.b[j] += parent.b[j] / PARENTS;
		}
	}
	return mean;
}

// Records the walk of a gait in a world alone, which has the bits of the world in the batch. Returns the distance, m.
static float record(scree_world* world, scree_body hull, const scree_joint* joints, const Gait* gait)
{
	scree_record_def def = scree_record_def_default();
	scree_pose pose;
	float reached = 0.0f;
	bool fallen = false;
	def.path = "gait.rec";
	scree_world_record(world, &def);
	for (int step = 0; step < STEPS; ++step)
	{
		for (int j = 0; j < JOINTS; ++j)
			scree_joint_set_motor_speed(world, joints[j], SCREE_ANGLE, speed_of(gait, j, step));
		scree_world_step(world, 1.0f / 60.0f, 4);
		scree_body_get_pose(world, hull, &pose);
		fallen = fallen || pose.position.y < FALLEN;
		reached = fallen ? reached : pose.position.x;
	}
	scree_world_end_recording(world);
	return reached;
}

int main(int count, char** arguments)
{
	static Gait gaits[WORLDS];
	static float speeds[WORLDS][JOINTS], poses[WORLDS][4];
	int order[WORLDS], found;
	Gait middle = {{0}, {0}}, best = middle;
	float spread = 0.8f; // rad/s, falls from generation to generation
	uint64_t sum = 0;
	bool prints = true;
	scree_scene* scene;
	scree_batch* batch;
	scree_body hull;
	scree_joint joints[JOINTS];
	scree_channel inputs[JOINTS], output = scree_channel_make(SCREE_OUTPUT_POSE);
	if (count < 2)
		return fprintf(stderr, "usage: evolve walker.json [DEVICE [GENERATIONS]]\n"), 2;
	const int generations = count > 3 ? atoi(arguments[3]) : 24;
	scree_fail_hook_set(stop, NULL);
#ifdef EVOLVE_MPI
	MPI_Init(&count, &arguments);
	scree_mpi_share(MPI_COMM_WORLD, WORLDS, &first, &worlds);
	prints = first == 0;
#endif

	// the template is the world of the scene, without steps in the way
	const scree_scene_setting setting = {"steps", "0"};
	scree_scene_def scene_def = scree_scene_def_default();
	scene_def.settings = &setting;
	scene_def.setting_count = 1;
	scree_scene_load(arguments[1], &scene_def, &scene);
	scree_world* template = scree_scene_get_world(scene);
	scree_scene_get_bodies(scene, "hull", &hull, 1, &found);
	scree_world_get_joints(template, joints, JOINTS, &found);

	scree_batch_def def = scree_batch_def_default();
	def.worlds = worlds;
	def.templates = &template;
	def.template_count = 1;
	def.device = count > 2 ? arguments[2] : "cpu";
	scree_batch_create(&def, &batch);
	for (int j = 0; j < JOINTS; ++j)
	{
		inputs[j] = scree_channel_make(SCREE_INPUT_MOTOR_SPEED);
		inputs[j].joint = joints[j];
		inputs[j].which = SCREE_ANGLE;
	}
	output.body = hull;
	scree_batch_bind(batch, SCREE_STEP_INPUTS, inputs, JOINTS, speeds[0]);
	scree_batch_bind(batch, SCREE_OUTPUTS, &output, 1, poses[0]);

	for (int generation = 0; generation < generations; ++generation, spread *= 0.95f)
	{
		for (int k = 0; k < worlds; ++k)
			gaits[k] = gait_of(&middle, spread, first + k, generation);
		walk(batch, gaits, speeds, poses);
		for (int k = 0; k < WORLDS; ++k)
			order[k] = k;
		qsort(order, WORLDS, sizeof *order, compare);
		best = gait_of(&middle, spread, order[0], generation);
		middle = mean_of(&middle, spread, generation, order);
		if (prints)
			printf("generation %2d: the best walks %.3f m, the middle one %.3f m\n", generation,
			       (double)distance[order[0]], (double)distance[order[WORLDS / 2]]);
	}
#ifdef EVOLVE_MPI
	scree_mpi_hash(batch, MPI_COMM_WORLD, &sum);
#else
	uint64_t hashes[WORLDS];
	scree_batch_get_hashes(batch, hashes);
	for (int k = 0; k < WORLDS; ++k)
		sum += hashes[k];
#endif
	if (prints)
	{
		const float reached = record(template, hull, joints, &best);
		printf("sum of the hashes %016llx\n", (unsigned long long)sum);
		printf("alone, the best walks %.3f m, %s; its recording is gait.rec\n", (double)reached,
		       reached == distance[order[0]] ? "as in the batch" : "which differs");
	}
	scree_batch_destroy(batch);
	scree_scene_destroy(scene);
#ifdef EVOLVE_MPI
	MPI_Finalize();
#endif
	return 0;
}
