/* SPDX-License-Identifier: BSD-3-Clause */
/* The smallest plug-in: one device that is a simulated hand of 0.2 kg on a soft spring. Forces move
 * it, and nobody can be hurt by it. */
#include <relievo_device.h>
#include <string.h>

static struct {
  double place_mm[3], speed_mm_s[3];
  int64_t last_ns;
  int is_open;
} hand;

static relievo_status openHand(void* self) {
  (void)self;
  memset(&hand, 0, sizeof hand);
  hand.is_open = 1;
  return RELIEVO_OK;
}

static void closeHand(void* self) {
  (void)self;
  hand.is_open = 0; /* A real device: zero force first. */
}

static relievo_status limitsOfHand(void* self, relievo_device_limits* out) {
  (void)self;
  out->flags = RELIEVO_HAS_VELOCITY | RELIEVO_HAS_OWN_WATCHDOG;
  for (int i = 0; i < 3; ++i) out->half_extent_mm[i] = 50;
  out->max_force_n = 4;
  out->continuous_force_n = 2;
  out->max_stiffness_n_per_mm = 1;
  out->position_step_mm = 0.02;
  out->force_delay_ms = 1;
  out->rate_hz = 1000;
  return RELIEVO_OK;
}

static relievo_status stepHand(void* self, const double force_n[3], int64_t now_ns,
                               relievo_sample* out) {
  (void)self;
  if (!hand.is_open) return RELIEVO_DISCONNECTED;
  const double kg = 0.2, spring_n_per_mm = 0.1, damping_n_s_per_mm = 0.004;
  double seconds = hand.last_ns == 0 ? 0.001 : 1e-9 * (double)(now_ns - hand.last_ns);
  if (seconds > 0.005) seconds = 0.005; /* After a pause it goes on where it was. */
  hand.last_ns = now_ns;
  out->buttons = 0;
  out->time_ns = now_ns;
  out->hottest_motor = -1;
  for (int i = 0; i < 3; ++i) {
    const double n = force_n[i] - spring_n_per_mm * hand.place_mm[i] -
                     damping_n_s_per_mm * hand.speed_mm_s[i];
    hand.speed_mm_s[i] += 1000 * n / kg * seconds;
    hand.place_mm[i] += hand.speed_mm_s[i] * seconds;
    out->position_mm[i] = hand.place_mm[i];
    out->velocity_mm_s[i] = hand.speed_mm_s[i];
  }
  return RELIEVO_OK;
}

static relievo_status cutForceOfHand(void* self) {
  (void)self; /* A real device: zero to the motors, whatever step is doing. */
  return RELIEVO_OK;
}
static const char* lastErrorOfHand(void* self) {
  (void)self;
  return "nothing went wrong";
}
static const void* noExtension(void* self, const char* id) {
  (void)self, (void)id;
  return NULL;
}

static relievo_device spring_hand = {sizeof spring_hand, 0, NULL, openHand, closeHand, limitsOfHand,
                                     stepHand, cutForceOfHand, lastErrorOfHand, noExtension};

static relievo_status init(const relievo_host* host, const char* own_path) {
  (void)host, (void)own_path;
  return RELIEVO_OK;
}
static void deinit(void) {}
static uint32_t scan(relievo_device_name* out, uint32_t capacity) {
  if (capacity > 0) {
    strcpy(out[0].id, "spring.1");
    strcpy(out[0].name, "Hand on a spring");
  }
  return 1;
}
static relievo_device* create(const char* id) {
  return strcmp(id, "spring.1") == 0 ? &spring_hand : NULL;
}
static void destroy(relievo_device* device) { (void)device; }

const relievo_device_entry_t relievo_device_entry = {
    sizeof relievo_device_entry, RELIEVO_DEVICE_ABI_MAJOR, RELIEVO_DEVICE_ABI_MINOR, 0,
    "Hand on a spring", "1.0", "the relievo authors", "BSD-3-Clause",
    init, deinit, scan, create, destroy};
