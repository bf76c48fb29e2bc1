// SPDX-License-Identifier: MIT
// run_report.c -- prints the progress bar of a run, and the table of its results.
#include "run_report.h"
#include "scene/caption.h"
#include "tools/common/clock.h"
#include <inttypes.h>
#include <unistd.h>

#define BAR       40   // width of the bar, characters
#define BAR_PAUSE 0.05 // s: time between two updates of the bar

void totals_add(Totals* totals, const Record* record)
{
	totals->last = *record;
	totals->seconds += 1e-3 * (double)record->milliseconds;
	totals->scans += 1e-3 * (double)record->scan;
	for (int k = 0; k < STAGE_TIMES; ++k)
		totals->stages[k] += (double)record->stages[k];
	if (record->counters.penetration > totals->penetration)
		totals->penetration = record->counters.penetration;
	if (record->counters.joint_gap > totals->joint_gap)
		totals->joint_gap = record->counters.joint_gap;
	totals->nonfinite += record->counters.frozen_bodies;
}

ProgressBar progress_bar(void) { return (ProgressBar){isatty(STDOUT_FILENO) && isatty(STDERR_FILENO), 0}; }

void progress_show(ProgressBar* bar, int step, int steps)
{
	double now = seconds_now();
	if (!bar->visible || (step < steps && now - bar->shown < BAR_PAUSE))
		return;
	bar->shown = now;
	int full = (int)((int64_t)BAR * step / steps);
	fprintf(stderr, "\r%d of %d steps [%.*s%*s]%s", step, steps, full, "########################################",
	        BAR - full, "", step < steps ? "" : "\r\033[K");
}

void print_results(const ScenePlayer* player, const Totals* totals, const char* const* stages, int steps, uint64_t hash)
{
	char device[192];
	const scree_counters* c = &totals->last.counters;
	device_text(player->world, device, sizeof device);
	printf("%-14s %s: %s\n", "scene", player->scene->name, player->scene->title);
	printf("%-14s %s\n", "device", device);
	printf("%-14s %d\n", "bodies", c->bodies);
	printf("%-14s %d, %d touching\n", "contacts", c->contacts, c->touching);
	printf("%-14s %d, %d contacts of hubs\n", "colors", c->colors, c->spokes);
	printf("%-14s %d in %.3f s\n", "steps", steps, totals->seconds);
	printf("%-14s %.1f\n", "steps/s", steps / totals->seconds);
	printf("%-14s %.4f\n", "ms/step", 1000 * totals->seconds / steps);
	for (int k = 0; stages && k < STAGE_TIMES; ++k)
		printf("  %-12s %.4f\n", stages[k], totals->stages[k] / steps);
	printf("%-14s %.4f m now, %.4f m the deepest seen\n", "penetration", (double)c->penetration,
	       (double)totals->penetration);
	printf("%-14s %.4f m now, %.4f m the widest seen\n", "joint gap", (double)c->joint_gap, (double)totals->joint_gap);
	if (totals->nonfinite > 0)
		printf("%-14s %d bodies were frozen because their state was not finite\n", "warning", totals->nonfinite);
	printf("%-14s %016" PRIx64 "\n", "hash", hash);
	if (player->scene->character_count > 0)
		printf("%-14s %d bodies by characters\n", "taken", player->characters.state.taken);
	if (player->scene->fan_count == 0)
		return;
	const ScanSum* sum = &player->answered;
	printf("%-14s %.0f a step, %.0f hit\n", "rays", (double)sum->rays / steps, (double)sum->hits / steps);
	printf("%-14s %.4f apart from the step\n", "ms/rays", 1000 * totals->scans / steps);
	printf("%-14s %016" PRIx64 "\n", "hash of rays", sum->hash);
}
