#include "libdem/law_driver/drive.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dem::law_driver {
namespace {

using contact::kernels::Lane3;

void put(Lane3& lane, const Vec3d& v) {
  lane.x[0] = v.x;
  lane.y[0] = v.y;
  lane.z[0] = v.z;
}
Vec3d get(const Lane3& lane) { return {lane.x[0], lane.y[0], lane.z[0]}; }

}  // namespace

// The other lanes of the pack stay apart and at rest; they get the parameters all the same, so that nothing divides by
// zero there.
Drive::Drive(const LawContact& contact)
    : contact_(contact),
      chunk_(std::make_unique<contact::kernels::LawChunk>()),
      work_(std::make_unique<contact::kernels::LawWork>()) {
  for (std::size_t i = 0; i < contact::kernels::chunk_size; ++i) {
    contact::each_parameter(chunk_->pair, contact_.pair,
                            [i](contact::kernels::Lane& lane, double value) { lane[i] = value; });
    chunk_->radius_eff[i] = contact_.radius_eff;
    chunk_->mass_eff[i] = contact_.mass_eff;
    chunk_->normal.z[i] = 1;
    work_->gain[i] = 1;
  }
}

const Answer& Drive::step(const Move& move) {
  contact::kernels::LawChunk& c = *chunk_;
  if (!(move.overlap > 0) && !(contact_.model.lingers && answer_.touching)) {
    end(move);
    answer_ = {};
    return answer_;
  }
  c.overlap[0] = move.overlap;
  put(c.normal, move.normal);
  put(c.velocity, move.velocity);
  put(c.relative_spin, move.relative_spin);
  c.turn[0] = move.turn;
  contact_.model.run(c, *work_, 1, move.dt, contact_.options, false);
  const contact::kernels::LawWork& w = *work_;
  const bool touching = c.history_overlap[0] > 0 || w.bond[0] > 0;
  if (touching)
    contact::book(c, w, 0, contact_.model.loss, move.prescribed ? w.dt_contact[0] : move.dt,
                  move.velocity + move.turned, ledger_);
  if (move.dt == 0) ledger_.lost = {};
  answer_.force = get(c.force);
  answer_.moment = get(c.couple);
  answer_.normal = w.normal.force[0] - w.pull[0];
  answer_.tangential = get(w.tangential);
  answer_.contact_radius = w.normal.contact_radius[0];
  answer_.stiffness = w.normal.stiffness[0];
  answer_.stiffness_t = w.normal.stiffness_t[0];
  answer_.damping = w.normal.damping[0];
  answer_.damping_t = w.normal.damping_t[0];
  answer_.energy = contact::stored_energy(c, w, 0);
  if (!touching) end(move);
  answer_.touching = touching;
  return answer_;
}

void Drive::end(const Move& move) {
  if (answer_.touching) {
    double acts = move.dt;  // of a prescribed motion the part up to the end
    if (move.prescribed && ledger_.closing < 0) acts = std::clamp(-ledger_.overlap / ledger_.closing, 0.0, move.dt);
    contact::close(contact_.model.loss, acts, ledger_);
  }
  for (std::size_t m = 0; m < lost_.size(); ++m) lost_[m] += ledger_.lost[m];
  ledger_ = {};
  for (std::size_t j = 0; j < contact_.model.words; ++j) work_->memory[j][0] = 0;
  put(chunk_->history_force, {});
  put(chunk_->history_normal, {});
  chunk_->history_overlap[0] = chunk_->history_twist[0] = 0;
}

std::vector<double> Drive::memory() const {
  std::vector<double> words(contact_.model.words);
  for (std::size_t j = 0; j < words.size(); ++j) words[j] = work_->memory[j][0];
  return words;
}

double Drive::lost(contact::Mechanism m) const {
  const auto i = static_cast<std::size_t>(m);
  return lost_[i] + ledger_.lost[i];
}

double Drive::lost() const {
  return std::accumulate(lost_.begin(), lost_.end(), 0.0) +
         std::accumulate(ledger_.lost.begin(), ledger_.lost.end(), 0.0);
}

double stable_step(const LawContact& contact, double overlap, double inverse_mass_n, double inverse_mass_t) {
  Drive drive(contact);
  const Answer& a = drive.step({.overlap = overlap});
  const auto limit = [](double stiffness, double damping, double inverse_mass) {
    const double omega = std::sqrt(stiffness * inverse_mass), beta = 0.5 * damping * inverse_mass / omega;
    return 2 / omega * (std::sqrt(1 + beta * beta) - beta);
  };
  const double normal = limit(a.stiffness, a.damping, inverse_mass_n);
  if (!(contact.pair.friction > 0) || !(a.stiffness_t > 0)) return normal;
  return std::min(normal, limit(a.stiffness_t, a.damping_t, inverse_mass_t));
}

}  // namespace dem::law_driver
