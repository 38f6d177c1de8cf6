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

  resource "three" do # web pages contain it
    url "https://registry.npmjs.org/three/-/three-0.111.0.tgz"
    sha256 "c0f06a76cad7d725a8a21d11d1de145e1f574d68cb130ab2f153e0c1c289bf41"
  end

  def install
    resource("three").stage buildpath/"three"
    system "cmake", "-S", ".", "-B", "build", "-G", "Ninja", "-DBUILD_TESTING=OFF",
           "-DSHAPE_CORRESPONDENCE_EXAMPLES=OFF",
           "-DSHAPE_CORRESPONDENCE_THREE_JS=#{buildpath}/three/build/three.module.js", *std_cmake_args
    system "cmake", "--build", "build"
    system "cmake", "--install", "build"
  end

  test do
    system bin/"shape_correspondence", "demo"
  end
end
