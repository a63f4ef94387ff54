// What is seen moves, what is not does not; nothing moves for those who asked their system for less motion.
const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
const pictures = [...document.querySelectorAll('img[data-loop]')];
for (const picture of pictures) picture.dataset.poster = picture.getAttribute('src');
const show = (picture, file) => {
  if (picture.getAttribute('src') !== picture.dataset[file]) picture.src = picture.dataset[file];
};
if (still) {
  for (const picture of pictures) {
    picture.addEventListener('pointerenter', () => show(picture, 'loop'));
    picture.addEventListener('pointerleave', () => show(picture, 'poster'));
  }
} else {
  const seen = new IntersectionObserver(entries => {
    for (const entry of entries) show(entry.target, entry.isIntersecting ? 'loop' : 'poster');
  }, {threshold: 0.2});
  for (const picture of pictures) seen.observe(picture);
}
