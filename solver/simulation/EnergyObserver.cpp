#include "simulation/EnergyObserver.h"

#include "core/Errors.h"

namespace squat::simulation {

long EnergyObserver::nextStep(long done) const {
  const long offset = done % interval_;
  return offset == 0 ? done + 1 : done + interval_ - offset;
}

void EnergyObserver::onStep(const dynamics::Rolling& rolling) {
  const long offset = rolling.state().step % interval_;
  if (offset == 1) balance_.after(rolling);
  if (offset == 0) balance_.before(rolling);
}

void EnergyObserver::save(results::ArrayTree& tree) const {
  tree.add("/energy_balance", balance_.pack(), "1");
  const auto shares = balance_.shares();
  tree.add("/energy_shares", std::vector<double>{shares.rail, shares.wheelset, shares.sleepers, shares.springs}, "J");
}

void EnergyObserver::load(const results::ArrayTree& tree, const std::string& file) {
  const auto& numbers = results::valuesOf<double>(tree, "/energy_balance", file);
  if (!EnergyBalance::isPacked(numbers)) throw FileError(file, "/energy_balance", "has a wrong length");
  const auto& shares = results::valuesOf<double>(tree, "/energy_shares", file);
  if (shares.size() != 4) throw FileError(file, "/energy_shares", "has a wrong length");
  balance_.unpack(numbers);
  balance_.setShares({shares[0], shares[1], shares[2], shares[3]});
}

}  // namespace squat::simulation
