// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/random/random.h"

#include <algorithm>
#include <array>

#include "axiometry/numeric/kernels/kernel_table.h"
#include "axiometry/numeric/random/philox.h"

namespace axiometry::numeric {

AXIOMETRY_KERNEL_TABLE(random_kernel, RandomKernel);

const RandomKernel& random_kernel_of(VectorTarget target) { return random_kernel_table.of(target); }

namespace {

RandomState starting_state(RandomKey key) {
  RandomState state;
  for (std::size_t lane = 0; lane < random_lanes; ++lane) {
    auto words = philox4x64({key.block, key.stream, lane, 0}, {key.seed, 0});
    if (std::ranges::all_of(words, [](std::uint64_t word) { return word == 0; })) words[0] = 1;
    for (std::size_t word = 0; word < words.size(); ++word) state.words[word][lane] = words[word];
  }
  return state;
}

/// Whole groups where they belong, and the beginning of one more.
template <std::size_t group, typename Number>
void fill(void (*make)(RandomState&, Number*, std::size_t), RandomState& state, std::span<Number> numbers) {
  const std::size_t whole = numbers.size() / group;
  make(state, numbers.data(), whole);
  const auto rest = numbers.subspan(whole * group);
  if (rest.empty()) return;
  std::array<Number, group> last;
  make(state, last.data(), 1);
  std::copy_n(last.begin(), rest.size(), rest.begin());
}

}  // namespace

RandomStream::RandomStream(RandomKey key, VectorTarget target)
    : state_(starting_state(key)), kernel_(&random_kernel_of(target)) {}

void RandomStream::fill_bits(std::span<std::uint64_t> numbers) {
  fill<RandomKernel::bits_group>(kernel_->bits, state_, numbers);
}

void RandomStream::fill_uniform(std::span<double> numbers) {
  fill<RandomKernel::uniform_group>(kernel_->uniform, state_, numbers);
}

void RandomStream::fill_normal(std::span<double> numbers) {
  fill<RandomKernel::normal_group>(kernel_->normal, state_, numbers);
}

void RandomStream::fill_normal(std::span<float> numbers) {
  fill<RandomKernel::normal_single_group>(kernel_->normal_single, state_, numbers);
}

void fill_uniform(RandomKey key, std::span<double> numbers) { RandomStream(key).fill_uniform(numbers); }
void fill_normal(RandomKey key, std::span<double> numbers) { RandomStream(key).fill_normal(numbers); }
void fill_normal(RandomKey key, std::span<float> numbers) { RandomStream(key).fill_normal(numbers); }

}  // namespace axiometry::numeric
