# Formula of the clone of this repository that it lies in, from a tap: see README.txt beside it. Nobody has built it yet.
class ShapeCorrespondence < Formula
  desc "Part correspondences of segmented 3D shapes"
  homepage "https://www.cgal.org"
  license "GPL-3.0-or-later"
  head "file://#{File.realpath(__FILE__).delete_suffix("/packaging/homebrew/shape-correspondence.rb")}", using: :git, branch: "main"

  depends_on "cmake" => :build
  depends_on "nanoflann" => :build
  depends_on "ninja" => :build
  depends_on "nlohmann-json" => :build
  depends_on "assimp"
  depends_on "boost"
  depends_on "cgal"
  depends_on "eigen"
  depends_on "jpeg-turbo"
  depends_on "libpng"
  depends_on "tbb"

  def install
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja", "-DBUILD_TESTING=OFF",
           "-DSHAPE_CORRESPONDENCE_EXAMPLES=OFF", *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
  end

  test do
    system bin/"shape_correspondence", "demo"
  end
end
