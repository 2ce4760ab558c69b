#include "distance/distance_fields.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "distance/window_distance.h"
#include "mesh/error.h"

namespace karcher {
namespace {

/// The work of a thread. It takes a point that no other thread has taken, computes its field, and
/// continues until no point remains.
class Worker {
 public:
  Worker(const Geometry& geometry, const Array<SurfacePoint>& points, double tolerance)
      : geometry_(geometry), points_(points), solver_(geometry, tolerance) {}

  void work(std::atomic<int>& taken, Array<Array<double>>& fields,
            Array<std::exception_ptr>& failures) {
    for (int i = taken++; i < points_.count(); i = taken++) {
      try {
        fields[i] = fieldOf(points_[i]);
      } catch (...) {
        failures[i] = std::current_exception();
      }
    }
  }

 private:
  Array<double> fieldOf(const SurfacePoint& point) {
    solver_.setSource(point);
    solver_.grow(kInfinity);
    Array<double> distances(geometry_.mesh->positions.size());
    for (int v = 0; v < distances.count(); ++v) distances[v] = solver_.distance(v);
    return distances;
  }

  const Geometry& geometry_;
  const Array<SurfacePoint>& points_;
  WindowDistance solver_;
};

/// Threads that the destructor joins, so that they end even if an exception leaves the block.
class Joined {
 public:
  Joined() = default;
  Joined(const Joined&) = delete;
  Joined& operator=(const Joined&) = delete;
  ~Joined() {
    for (std::thread& thread : threads_) thread.join();
  }

  template <typename Work>
  void start(Work work) {
    threads_.emplace_back(std::move(work));
  }

 private:
  Array<std::thread> threads_;
};

}  // namespace

Array<Array<double>> distanceFields(const Geometry& geometry, const Array<SurfacePoint>& points,
                                    double tolerance, int threads) {
  if (threads < 1) {
    throw Error(ErrorCode::kBadArgument,
                "the number of threads must be at least 1, not " + std::to_string(threads));
  }
  Array<Array<double>> fields(points.size(), Array<double>());
  Array<std::exception_ptr> failures(points.size(), nullptr);
  std::atomic<int> taken = 0;
  // All workers exist before the first one starts, so that an exception of a constructor leaves no
  // thread behind.
  Array<std::unique_ptr<Worker>> workers;
  for (int i = 0; i < std::min(threads, points.count()); ++i) {
    workers.push_back(std::make_unique<Worker>(geometry, points, tolerance));
  }
  {
    Joined others;
    for (int i = 1; i < workers.count(); ++i) {
      others.start([&, i] { workers[i]->work(taken, fields, failures); });
    }
    if (!workers.empty()) workers[0]->work(taken, fields, failures);
  }
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  return fields;
}

}  // namespace karcher
