// Sums by trees: of a workgroup's invocations, then of all workgroups' rows. The last stage is the processor's, in f64.

const GROUP = 64u;

var<workgroup> energies_of: array<vec4f, GROUP>;
var<workgroup> least_of: array<vec2f, GROUP>;

// The sums over a workgroup, known to its first invocation. All invocations take part.
fn sum_of_group(lane: u32, energies: vec4f, least: vec2f) -> Sums {
    energies_of[lane] = energies;
    least_of[lane] = least;
    for (var reach = GROUP / 2u; reach > 0u; reach /= 2u) {
        workgroupBarrier();
        if lane < reach {
            energies_of[lane] += energies_of[lane + reach];
            least_of[lane] = min(least_of[lane], least_of[lane + reach]);
        }
    }
    return Sums(energies_of[lane], least_of[lane], 0.0);
}

// Rows to as many results as there are workgroups.
@compute @workgroup_size(GROUP)
fn reduce(
    @builtin(global_invocation_id) id: vec3u,
    @builtin(local_invocation_index) lane: u32,
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    var energies = vec4f();
    var least = vec2f(LARGEST);
    for (var row = id.x; row < arrayLength(&rows); row += groups.x * GROUP) {
        energies += rows[row].energies;
        least = min(least, rows[row].least);
    }
    let sums = sum_of_group(lane, energies, least);
    if lane == 0u {
        results[group.x] = sums;
    }
}
