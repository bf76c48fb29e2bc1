// SPDX-License-Identifier: MIT
// paper_player.c -- plays a scene with the pipeline of the paper.
#include "tools/paper/paper_player.h"
#include "cli/common/library_error.h"
#include "scene/churn.h"
#include "tools/common/clock.h"

const char* const paper_stages[STAGE_TIMES] = {"to_device", "integrate",   "transform",
                                               "detect",    "from_device", "resolve"};

bool paper_takes(const Scene* scene)
{
	const char* reason = NULL;
	if (scene_churns(scene))
		reason = "changes bodies between steps, which the paper's pipeline cannot";
	else if (scene->field_count > 0 || scene->blast_count > 0)
		reason = "has fields or explosions, which the paper's pipeline does not have";
	else if (scene->joint_count > 0)
		reason = "has joints, which the paper's pipeline does not have";
	else if (scene->character_count > 0)
		reason = "has characters, which need queries; the paper's pipeline has none";
	else if (scene->fan_count > 0)
		reason = "casts rays, which the paper's pipeline cannot";
	if (reason)
		fprintf(stderr, "%s: %s %s\n", program_name, scene->name, reason);
	return !reason;
}

int paper_player_open(const Options* options, const Scene* scene, PaperPlayer* paper)
{
	*paper = (PaperPlayer){0};
	if (!paper_takes(scene))
		return EXIT_BAD;
	Options one = *options; // options with one thread and one lane, as in the paper's pipeline
	one.threads = one.lanes = 1;
	one.device = options->device ? options->device : "cpu";
	int code = open_player(&one, scene, false, &paper->player);
	if (code != EXIT_GOOD)
		return code;
	scree_world* world = paper->player.world;
	code = report(paper_create(world, scree_world_get_device(world), options->allow_unequal_bits, &paper->paper));
	if (code != EXIT_GOOD)
		paper_player_close(paper);
	return code;
}

void paper_player_close(PaperPlayer* paper)
{
	paper_destroy(paper->paper);
	paper->paper = NULL;
	player_close(&paper->player);
}

static void read_timings(const Paper* paper, float stages[STAGE_TIMES])
{
	PaperTimings t = paper_timings(paper);
	const double all[STAGE_TIMES] = {t.to_device, t.integrate, t.transform, t.detect, t.from_device, t.resolve};
	for (int k = 0; k < STAGE_TIMES; ++k)
		stages[k] = (float)all[k];
}

static scree_status read_counters(const PaperPlayer* paper, scree_counters* counters)
{
	PaperCounters c = paper_counters(paper->paper);
	scree_status status = scree_world_get_counters(paper->player.world, counters);
	counters->contacts = counters->touching = c.contacts;
	counters->penetration = c.penetration;
	counters->steps = c.steps;
	return status;
}

scree_status paper_record_step(PaperPlayer* paper, Record* record)
{
	*record = (Record){0};
	double start = seconds_now();
	// one step of dt: the paper has no substeps
	scree_status status = paper_step(paper->paper, paper->player.scene->dt);
	++paper->player.steps;
	if (status == SCREE_OK)
		status = read_counters(paper, &record->counters);
	record->milliseconds = (float)(1000 * (seconds_now() - start));
	read_timings(paper->paper, record->stages);
	return status;
}
