/* The digest of limit surfaces besides the disk's in one precision; included by digest_real.h. */

static void LOCAL(other_surfaces)(struct stream *s, enum range range)
{
    REAL p[5], x[12];
    NAME(round) patch;
    NAME(node) nodes[4];
    NAME(wrench) wrench;
    NAME(projection) nearest = {{0, 0, 0}, {0, 0, 0}, 0};
    NAME(wrench) pushes[LOCAL(BATCH)];
    NAME(projection) all[LOCAL(BATCH)];
    REAL loads[LOCAL(BATCH)];
    tribos_status status;
    int i;

    LOCAL(draws)(s, FIT, p, 5);
    LOCAL(draws)(s, MILD, x, 12);
    wrench = LOCAL(draw_wrench)(s, range);
    patch.coefficient = p[0];
    patch.radius = p[1];
    NUMBER(NAME(annulus_gauge)(&patch, p[4] / 2, p[2], &wrench, &out));
    status = NAME(annulus_project)(&patch, p[4] / 2, p[2], &wrench, p[3], &nearest);
    LOCAL(feed_projection)(s, status, nearest);
    NUMBER(NAME(hertz_gauge)(&patch, p[2], &wrench, &out));
    status = NAME(hertz_project)(&patch, p[2], &wrench, p[3], &nearest);
    LOCAL(feed_projection)(s, status, nearest);
    NUMBER(NAME(ring_gauge)(&patch, p[2], &wrench, &out));
    status = NAME(ring_project)(&patch, p[2], &wrench, p[3], &nearest);
    LOCAL(feed_projection)(s, status, nearest);
    NUMBER(NAME(punch_gauge)(&patch, p[2], &wrench, &out));
    status = NAME(punch_project)(&patch, p[2], &wrench, p[3], &nearest);
    LOCAL(feed_projection)(s, status, nearest);
    LOCAL(draws)(s, range, loads, LOCAL(BATCH));
    for (i = 0; i < LOCAL(BATCH); ++i) {
        pushes[i] = LOCAL(draw_wrench)(s, range);
    }
    status = NAME(annulus_project_batch)(
        &patch, p[4] / 2, loads, pushes, LOCAL(BATCH), p[3], all);
    LOCAL(feed_projections)(s, status, all);
    status = NAME(hertz_project_batch)(&patch, loads, pushes, LOCAL(BATCH), p[3], all);
    LOCAL(feed_projections)(s, status, all);
    status = NAME(ring_project_batch)(&patch, loads, pushes, LOCAL(BATCH), p[3], all);
    LOCAL(feed_projections)(s, status, all);
    status = NAME(punch_project_batch)(&patch, loads, pushes, LOCAL(BATCH), p[3], all);
    LOCAL(feed_projections)(s, status, all);
    for (i = 0; i < 4; ++i) {
        nodes[i].x = x[3 * i];
        nodes[i].y = x[3 * i + 1];
        nodes[i].weight = x[3 * i + 2] < 0 ? -x[3 * i + 2] : x[3 * i + 2];
    }
    NUMBER(NAME(nodes_gauge)(nodes, 4, p[0], &wrench, &out));
    status = NAME(nodes_project)(nodes, 4, p[0], &wrench, p[3], &nearest);
    LOCAL(feed_projection)(s, status, nearest);
}
