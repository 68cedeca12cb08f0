#pragma once
/// The single lines of a summary, without their labels.

#include <string>
#include <vector>

#include <spectralpack/spectralpack.hpp>

#include "summary.hpp"

namespace spectralpack::cli {

std::string size_text(const Vec3& size);  ///< "480 x 245 x 200 mm"
std::string verdict_text(const PackResult& result);
std::string tray_text(const Packing& packing, const RunFacts& facts);
std::string height_text(const Packing& packing, const RunFacts& facts);
std::string filled_text(const Packing& packing);
std::string shares_text(const Packing& packing);
std::string gap_text(const Packing& packing, const TakenOver& taken);
std::vector<std::string> checked_texts(const Packing& packing, const RunFacts& facts);
std::string written_text(const RunFacts& facts, bool several_trays);
std::string progress_text(const Improved& improved);  ///< "121.3 mm high, 14.6 mm lower than at first"
std::string improved_text(const Improved& improved);
std::string took_text(const Metrics& metrics, double seconds);

}  // namespace spectralpack::cli
